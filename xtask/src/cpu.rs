//! CPU time, which differs less between machines than elapsed time.

/// Clock ticks per second in `/proc`; fixed by the ABI of Linux on all common architectures.
#[cfg(target_os = "linux")]
const TICKS: f64 = 100.0;

/// Returns the CPU time of all finished child processes and their children, in seconds. `None` if the system does not report it.
pub fn of_children() -> Option<f64> {
    #[cfg(target_os = "linux")]
    {
        parse(&std::fs::read_to_string("/proc/self/stat").ok()?)
    }
    #[cfg(not(target_os = "linux"))]
    None
}

/// Reads `cutime` and `cstime` of `/proc/self/stat` (proc(5)). The name in parentheses may contain spaces.
#[cfg(target_os = "linux")]
fn parse(stat: &str) -> Option<f64> {
    let (_, fields) = stat.rsplit_once(')')?;
    let mut children = fields.split_whitespace().skip(13).take(2).map(|field| field.parse::<f64>().ok());
    Some((children.next()?? + children.next()??) / TICKS)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn the_time_of_children_is_read() {
        let stat = "7 (a (b) c) S 1 7 7 0 -1 4194304 1 2 3 4 10 20 350 50 20 0 1 0";
        assert_eq!(parse(stat), Some(4.0));
        assert_eq!(parse("7 (a) S 1"), None);
        assert!(of_children().is_some());
    }
}
