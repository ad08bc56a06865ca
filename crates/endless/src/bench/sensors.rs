//! `endless bench --rig`: what each sensor of a recording costs.

use anyhow::Result;
use endless_pipeline::Generated;
use std::io::Write;

/// A line for each sensor, and one for all of them.
///
/// The time of a sensor is that of all threads together, from the world state to its files. Rates are those of as many
/// threads as there are, if they did nothing else; the last line is wall time.
pub(super) fn print(made: &Generated, threads: usize) -> Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(out)?;
    writeln!(out, "sensor           measurements   ms each   a second   million points/s")?;
    for sensor in &made.sensors {
        let seconds = sensor.time.as_secs_f64().max(1e-9);
        let a_second = |count: u64| count as f64 * threads as f64 / seconds;
        let each_ms = seconds * 1e3 / sensor.measurements.max(1) as f64;
        let rate = a_second(sensor.measurements);
        write!(out, "{:<16} {:>12} {each_ms:>9.2} {rate:>10.1}", sensor.name, sensor.measurements)?;
        match sensor.points {
            0 => writeln!(out)?,
            points => writeln!(out, " {:>18.2}", a_second(points) / 1e6)?,
        }
    }
    let (count, seconds) = (made.camera_frames as f64, made.times.record.as_secs_f64().max(1e-9));
    let each_ms = seconds * 1e3 / count;
    let rate = count / seconds;
    writeln!(out, "{:<16} {:>12} {each_ms:>9.2} {rate:>10.1}   (wall time)", "all together", made.camera_frames)?;
    Ok(())
}
