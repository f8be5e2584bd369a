//! The costs of updates and of queries, in orientation tests and in bytes.

use std::cell::Cell;
use std::cmp::Ordering;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::super::*;
use super::{planar, sorted};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::orientation::Turn;

/// A point that counts the turns and the crossings that it is asked for.
#[derive(Debug, Clone, Copy)]
struct Counted<'a>(PlanarPoint, &'a Cell<u64>);

impl Site for Counted<'_> {
    fn order(&self, other: &Self) -> Ordering {
        self.0.order(&other.0)
    }

    fn abscissa_order(&self, other: &Self) -> Ordering {
        self.0.abscissa_order(&other.0)
    }

    fn order_along(&self, other: &Self, direction: Direction) -> Ordering {
        self.1.set(self.1.get() + 1);
        self.0.order_along(&other.0, direction)
    }

    fn turn(a: &Self, b: &Self, c: &Self) -> Turn {
        a.1.set(a.1.get() + 1);
        Site::turn(&a.0, &b.0, &c.0)
    }

    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering {
        at.1.set(at.1.get() + 1);
        Site::crossing_order(first.map(|site| &site.0), second.map(|site| &site.0), &at.0)
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        self.0.homogeneous()
    }
}

fn square(count: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    (0..count).map(|_| [0; 2].map(|_| random.random_range(-1.0..1.0))).collect()
}

fn circle(count: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    let on_circle = |angle: f64| {
        let (sine, cosine) = libm::sincos(angle);
        [cosine, sine]
    };
    (0..count).map(|_| on_circle(random.random_range(0.0..std::f64::consts::TAU))).collect()
}

/// Every site is a vertex of the lower chain.
fn parabola(count: usize, _: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    (0..count).map(|k| [k as f64, k as f64 * k as f64]).collect()
}

#[test]
fn turns_grow_like_the_square_of_the_height() {
    for points in [square, circle, parabola] {
        for height in [8, 10, 12, 14] {
            let (turns, mut random) = (Cell::new(0), Pcg64Mcg::seed_from_u64(height));
            let count = 1usize << height;
            let sites: Vec<Counted> =
                planar(&points(count, &mut random)).into_iter().map(|point| Counted(point, &turns)).collect();
            let all = (0..count as u32).map(SiteIndex);
            let mut chain = DynamicChain::new(sorted(&sites), Side::Lower, all).expect("distinct indices");
            let (mut most, mut total, updates) = (0, 0, 2000);
            for _ in 0..updates {
                // half of the updates are made where they cost most: vertices of the whole chain
                let vertex = Direction::at_abscissa(random.random_range(-2.0..2.0)).ok().and_then(|d| chain.extreme(d));
                let random_site = SiteIndex(random.random_range(0..count as u32));
                let site = if random.random() { vertex.unwrap_or(random_site) } else { random_site };
                turns.set(0);
                chain.delete(site).expect("all sites are present");
                chain.insert(site).expect("it was deleted");
                most = most.max(turns.get());
                total += turns.get();
            }
            let mean = total as f64 / f64::from(updates);
            println!("n = 2^{height}: {mean:.1} turns a deletion and insertion, at most {most}");
            // a bridge of the level k from the leaves takes at most 2 k steps of five tests
            assert!(most <= 6 * (height + 1).pow(2), "n = 2^{height}: {most}");
            turns.set(0);
            chain.extreme(Direction::at_abscissa(0.3).expect("a finite abscissa"));
            chain.tangent(&sites[0], Towards::Left);
            assert!(turns.get() <= 2 * height, "n = 2^{height}: {} in two queries", turns.get());
        }
    }
}

#[test]
fn no_chain_holds_more_than_100_bytes_a_site() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    // one site more than a power of two, where a complete tree has the largest share of empty leaves
    for (points, count) in [(circle as fn(_, &mut _) -> _, 4097), (square, 4097), (circle, 4096)] {
        let sites = sorted(&planar(&points(count, &mut random)));
        let chain = |side| {
            let start = (0..count as u32 / 2).map(SiteIndex);
            let mut chain = DynamicChain::new(sites.clone(), side, start).expect("distinct");
            for site in (0..count as u32).map(SiteIndex) {
                let _ = chain.insert(site);
            }
            chain
        };
        let [lower, upper] = [Side::Lower, Side::Upper].map(|side| chain(side).bytes());
        let bytes = (lower + upper - sites.bytes()) as f64 / count as f64;
        println!("{bytes:.1} bytes a site for both chains");
        assert!(bytes <= 100.0, "{bytes}");
    }
}
