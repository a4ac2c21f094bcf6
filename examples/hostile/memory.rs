//! Measures peak memory of a task on Linux. Returns nothing on other systems.

use std::fs;

/// Resets the peak, and returns the bytes in use.
pub(crate) fn begin() -> Option<u64> {
    // See proc(5): writing 5 resets the peak to the current memory use.
    fs::write("/proc/self/clear_refs", "5").ok()?;
    field("VmRSS:")
}

/// The peak since then, above what was in use.
pub(crate) fn most_since(before: u64) -> Option<u64> {
    Some(field("VmHWM:")?.saturating_sub(before))
}

fn field(name: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(name))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? * 1024)
}
