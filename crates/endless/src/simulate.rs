//! `endless simulate`: the traffic of a map without pictures.

use crate::args::{SimulateArgs, SimulateOutputs};
use crate::exit::FAILURE;
use crate::file::{make_folder_of, write};
use crate::memory;
use crate::simulate_options::{OutputFile, TopViewFormat, VehicleCount};
use anyhow::Result;
use endless_asset::Catalogue;
use endless_dataset::{VideoEncoder, encode_png, yuv_from_rgb};
use endless_interchange::{MapLibrary, TopView, TrajectoryFormat, TrajectoryScene, TrajectoryWriter};
use endless_town::Town;
use endless_traffic::{
    AuditReport, DrivingCondition, Fleet, Population, Simulation, TrafficAudit, TrafficMap, TrafficSettings,
    USUAL_DELIVERIES,
};
use endless_world::{Condition, ImageSize, TrafficProfile, WorldState};
use std::{
    io::{self, Write},
    path::Path,
    process::ExitCode,
    time::{Duration, Instant},
};

/// Traffic is looked at at least so often a second: in each of its steps.
const LOOKS_A_SECOND: f64 = 30.0;
/// Width and height of views from above, pixels.
const TOP_VIEW: u32 = 1080;
/// Memory may grow by so much after a tenth of the time, megabytes.
const GROWTH_MB: f64 = 16.0;

pub(crate) fn run(library: &MapLibrary, args: &SimulateArgs) -> Result<ExitCode> {
    let town = town(library, &args.map)?;
    let catalogue = library.catalogue();
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    // Traffic is the same whatever is written of it.
    let every = (LOOKS_A_SECOND / args.fps - 1e-9).ceil().max(1.0) as u32;
    let map = TrafficMap::new(town.network.clone(), &specs);
    let vehicles = match args.vehicles {
        VehicleCount::Number(number) => number,
        VehicleCount::Max => map.most_that_flow(),
    };
    let settings = TrafficSettings {
        vehicles,
        pedestrians: args.pedestrians,
        seed: args.seed,
        fps: args.fps * f64::from(every),
        condition: DrivingCondition::from(Condition::of(args.weather, args.time)),
        profile: TrafficProfile {
            region: args.region,
            two_wheelers: args.two_wheelers,
            bicycles: args.bicycles,
            heavy_vehicles: args.heavy_vehicles,
            clothing: args.clothing,
            aggressiveness: args.aggressiveness,
            signals: args.signals,
            ..TrafficProfile::default()
        },
        jaywalking: args.jaywalking,
        groups: args.groups,
        bus_stops: town.bus_stops(),
        bench_seats: town.bench_seats(),
        parking_bays: town.parking_bays.clone(),
        deliveries: USUAL_DELIVERIES,
        ..TrafficSettings::default()
    };
    let mut traffic = Simulation::on_map(&map, &fleet, &town.parked, &settings)?;
    let mut files = Files::begin(&args.wanted, &town, catalogue, &specs, args.fps)?;
    let mut audit = args.wanted.audit.then(|| {
        TrafficAudit::new(&town.network, &specs, traffic.parked(), settings.fps)
            .with_aggressiveness(args.aggressiveness)
            .with_bench_seats(&settings.bench_seats)
            .with_parking_bays(&settings.parking_bays)
    });
    let frames = (args.seconds * settings.fps).round() as u32;
    let mut simulating = Duration::ZERO;
    let mut held_mb = None;
    for frame in 0..=frames {
        if frame > 0 {
            let begin = Instant::now();
            traffic.tick();
            simulating += begin.elapsed();
        }
        let writes = frame % every == 0;
        if audit.is_some() || writes {
            let state = traffic.state();
            audit.iter_mut().for_each(|audit| audit.look(&state));
            if writes {
                files.instant(&state)?;
            }
        }
        if frame == frames / 10 {
            held_mb = memory::megabytes();
        }
    }
    let memory_mb = held_mb.zip(memory::megabytes());
    files.finish(&traffic.state())?;
    let mut out = io::stdout().lock();
    writeln!(out, "{}", summary(&town.name, args.seconds, simulating, traffic.population()))?;
    let Some(report) = audit.map(|audit| audit.report()) else { return Ok(ExitCode::SUCCESS) };
    let flat = memory_mb.is_none_or(|(before, after)| after - before <= GROWTH_MB);
    print_audit(&mut out, &report, traffic.population(), memory_mb, flat)?;
    Ok(if report.passed() && flat { ExitCode::SUCCESS } else { ExitCode::from(FAILURE) })
}

/// A map by its name, or from a file. Names of maps have neither points nor slashes.
fn town(library: &MapLibrary, map: &str) -> Result<Town> {
    let is_file = map.contains(['.', '/', '\\']);
    Ok(if is_file { library.town_of_file(Path::new(map))? } else { library.town(map)? })
}

fn summary(map: &str, seconds: f64, simulating: Duration, population: Population) -> String {
    let Population { vehicles_spawned, vehicle_capacity, pedestrians_spawned, .. } = population;
    let spent_s = simulating.as_secs_f64();
    format!(
        "{map}: {vehicles_spawned} vehicles (of at most {vehicle_capacity}) and {pedestrians_spawned} people, {seconds} s \
         simulated in {spent_s:.1} s, {:.0} times as fast as real time",
        seconds / spent_s.max(1e-9)
    )
}

fn print_audit(
    out: &mut impl Write,
    report: &AuditReport,
    population: Population,
    memory_mb: Option<(f64, f64)>,
    flat: bool,
) -> io::Result<()> {
    let mean = |metres: f64, of: u32| metres / f64::from(of.max(1)) / report.seconds.max(1e-9);
    let driven_mps = mean(report.driven_m, population.vehicles_spawned);
    let walked_mps = mean(report.walked_m, population.pedestrians_spawned);
    writeln!(out, "mean speeds, all stands included: {driven_mps:.2} m/s driving, {walked_mps:.2} m/s on foot")?;
    write!(out, "{report}")?;
    let verdict = if flat { "PASS" } else { "FAIL" };
    match memory_mb {
        Some((before, after)) => writeln!(
            out,
            "{verdict}  {:<46} {:>10.1} {:<5}  at most {GROWTH_MB} MB",
            "memory gained after a tenth of the time",
            (after - before).max(0.0),
            "MB"
        ),
        None => writeln!(out, "      memory is not counted on this system"),
    }
}

/// What is written while traffic is simulated.
struct Files<'a> {
    trajectories: Option<(TrajectoryScene<'a>, TrajectoryWriter)>,
    top_view: Option<(TopView, TopViewSink<'a>)>,
}

enum TopViewSink<'a> {
    Picture(&'a Path),
    Video(Box<VideoEncoder>),
}

impl<'a> Files<'a> {
    fn begin(
        wanted: &'a SimulateOutputs,
        town: &'a Town,
        catalogue: &Catalogue,
        specs: &'a [endless_world::VehicleSpec],
        fps: f64,
    ) -> Result<Self> {
        let begin = |OutputFile { path, format }: &OutputFile<TrajectoryFormat>| -> Result<_> {
            make_folder_of(path)?;
            let scene = TrajectoryScene::new(&town.network, specs, town.streets.left_hand);
            Ok((scene, TrajectoryWriter::create(path, *format)?))
        };
        let begin_view = |OutputFile { path, format }: &'a OutputFile<TopViewFormat>| -> Result<_> {
            make_folder_of(path)?;
            let size = ImageSize { width: TOP_VIEW, height: TOP_VIEW };
            let sink = match format {
                TopViewFormat::Picture => TopViewSink::Picture(path),
                TopViewFormat::Video => TopViewSink::Video(Box::new(VideoEncoder::create(path, size, fps)?)),
            };
            Ok((TopView::new(town, catalogue, TOP_VIEW), sink))
        };
        Ok(Self {
            trajectories: wanted.out.as_ref().map(begin).transpose()?,
            top_view: wanted.top_view.as_ref().map(begin_view).transpose()?,
        })
    }

    fn instant(&mut self, state: &WorldState) -> Result<()> {
        if let Some((scene, writer)) = &mut self.trajectories {
            writer.push(state.time_s, &scene.rows(state))?;
        }
        if let Some((view, TopViewSink::Video(video))) = &mut self.top_view {
            video.push(&yuv_from_rgb(&view.draw(state)))?;
        }
        Ok(())
    }

    fn finish(self, last: &WorldState) -> Result<()> {
        if let Some((_, writer)) = self.trajectories {
            writer.finish()?;
        }
        match self.top_view {
            Some((view, TopViewSink::Picture(path))) => write(path, &encode_png(&view.draw(last)))?,
            Some((_, TopViewSink::Video(video))) => video.finish()?,
            None => {}
        }
        Ok(())
    }
}
