//! The library's own time for memberships of many points, which the package of Python is held against.
//!
//! `memberships FILE` reads doubles, little-endian: the numbers of generators and of points, the generators and the
//! points, three coordinates each. It prints the nanoseconds that a point takes on one thread.

use std::time::Instant;

use zonotope::Zonotope;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).ok_or("memberships FILE")?;
    let bytes = std::fs::read(file)?;
    let numbers: Vec<f64> = bytes.as_chunks().0.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
    let [generators, points, coordinates @ ..] = numbers.as_slice() else { return Err("too few numbers".into()) };
    let vectors: Vec<[f64; 3]> = coordinates.as_chunks().0.to_vec();
    let (rows, asked) = vectors.split_at_checked(*generators as usize).ok_or("too few generators")?;
    if asked.len() != *points as usize {
        return Err("not as many points as the file says".into());
    }
    let body = Zonotope::new([0.0; 3], rows.to_vec())?;
    let start = Instant::now();
    let answers = asked.iter().map(|&point| body.contains(point)).collect::<Result<Vec<bool>, _>>()?;
    let elapsed = start.elapsed();
    let inside = answers.iter().filter(|&&is_inside| is_inside).count();
    eprintln!("{inside} of {} points are inside", answers.len());
    println!("{}", elapsed.as_nanos() as f64 / answers.len().max(1) as f64);
    Ok(())
}
