//! Where the queue on a road will end once all in it stand.

/// Room between two who stand one behind the other, metres.
const APART_M: f64 = 2.5;

/// Somebody on a road; metres along it from its beginning.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Queued {
    pub(crate) vehicle: usize,
    pub(crate) rear: f64,
    pub(crate) front: f64,
    /// How far it would go on if nobody were ahead, metres.
    pub(crate) goes_on_m: f64,
    /// Whether it passes the others, and stands beside them.
    pub(crate) filters: bool,
}

/// The rear of the last one, metres; infinity if there is nobody. Nobody gets further than to the line at the end of the road,
/// unless they are over it already, nor into those ahead.
pub(crate) fn queue_tail_m(queue: &mut Vec<Queued>, line_m: f64) -> f64 {
    // Who covers two pieces of the road is there once.
    queue.sort_by(|a, b| b.rear.total_cmp(&a.rear).then(a.vehicle.cmp(&b.vehicle)));
    queue.dedup_by_key(|one| one.vehicle);
    let (mut tail, mut free_to) = (f64::INFINITY, line_m);
    for one in queue {
        let most = if one.filters || one.front > line_m { f64::INFINITY } else { free_to - (one.front - one.rear) };
        let stands = (one.rear + one.goes_on_m).min(most).max(one.rear);
        tail = tail.min(stands);
        if !one.filters {
            free_to = free_to.min(stands - APART_M);
        }
    }
    tail
}

#[cfg(test)]
mod tests {
    use super::*;

    fn car(vehicle: usize, rear: f64, goes_on_m: f64) -> Queued {
        Queued { vehicle, rear, front: rear + 4.5, goes_on_m, filters: false }
    }

    #[test]
    fn who_drives_on_stands_behind_those_ahead_and_before_the_line() {
        let tail = |mut queue: Vec<Queued>, line_m: f64| queue_tail_m(&mut queue, line_m);
        assert_eq!(tail(vec![], 30.0), f64::INFINITY);
        assert_eq!(tail(vec![car(0, 2.0, 3.0)], 30.0), 5.0);
        assert_eq!(tail(vec![car(0, 2.0, 40.0)], 30.0), 25.5);
        assert_eq!(tail(vec![car(0, 2.0, 40.0)], f64::INFINITY), 42.0);
        assert_eq!(tail(vec![car(0, 26.0, 40.0)], 30.0), 66.0, "it is over the line");
        let stands = car(1, 20.0, 0.0);
        assert_eq!(tail(vec![car(0, 2.0, 40.0), stands], 30.0), 20.0 - APART_M - 4.5);
        assert_eq!(tail(vec![car(0, 14.0, 40.0), stands], 30.0), 14.0, "nobody is moved back");
        let rider = Queued { filters: true, ..car(2, 2.0, 40.0) };
        assert_eq!(tail(vec![stands, rider], 30.0), 20.0);
        assert_eq!(tail(vec![stands, stands], 30.0), 20.0, "once");
    }
}
