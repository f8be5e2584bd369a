//! All sites that may ever be present, sorted once: equal sites share a location, and locations are numbered from the
//! left.

use std::cmp::Ordering;

use thiserror::Error;

use super::presence::Presence;
use super::site::Site;

/// The position of a site in the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SiteIndex(pub u32);

impl SiteIndex {
    /// The index as a position in the input slice.
    pub fn position(self) -> usize {
        self.0 as usize
    }
}

/// The largest number of sites: the leaves of a tree over them, a power of two, and its nodes fit in 32 bits.
pub const MAX_SITES: usize = (1 << 31) - 1;

/// There are more than [`MAX_SITES`] sites.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("{count} sites are more than the {MAX_SITES} that can be numbered")]
pub struct TooManySites {
    /// How many there are.
    pub count: usize,
}

/// Sites sorted by abscissa, then ordinate, then index.
///
/// A location is a point at which there is a site, a place is a position in the sorted order. Both chains of a hull and
/// both envelopes of a walk share one such list.
#[derive(Debug, Clone)]
pub struct SortedSites<S> {
    /// The point of each location, ascending and distinct.
    points: Vec<S>,
    /// By location: its first place. One more than locations; the last is the number of sites.
    first_places: Vec<u32>,
    /// By place: the index of the site there.
    indices: Vec<u32>,
    /// By index: the place.
    places: Vec<u32>,
    /// By place: the location.
    locations: Vec<u32>,
}

impl<S: Site> SortedSites<S> {
    /// The sites in order. O(n log n).
    ///
    /// # Errors
    /// [`TooManySites`] if there are more than [`MAX_SITES`].
    pub fn new(sites: &[S]) -> Result<Self, TooManySites> {
        let count = sites.len();
        if count > MAX_SITES {
            return Err(TooManySites { count });
        }
        let mut indices: Vec<u32> = (0..count as u32).collect();
        indices.sort_unstable_by(|&a, &b| sites[a as usize].order(&sites[b as usize]).then(a.cmp(&b)));
        let (mut points, mut first_places) = (Vec::<S>::new(), Vec::new());
        let (mut places, mut locations) = (vec![0; count], Vec::with_capacity(count));
        for (place, &index) in (0..).zip(&indices) {
            let site = sites[index as usize];
            if points.last().is_none_or(|last| last.order(&site) != Ordering::Equal) {
                points.push(site);
                first_places.push(place);
            }
            places[index as usize] = place;
            locations.push(points.len() as u32 - 1);
        }
        first_places.push(count as u32);
        points.shrink_to_fit();
        first_places.shrink_to_fit();
        Ok(Self { points, first_places, indices, places, locations })
    }

    /// How many sites there are, present or not.
    pub fn len(&self) -> usize {
        self.indices.len()
    }

    /// Whether there are no sites.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// The site with an index; `None` if there is no such site.
    pub fn site(&self, index: SiteIndex) -> Option<&S> {
        let place = *self.places.get(index.position())?;
        Some(&self.points[self.locations[place as usize] as usize])
    }

    /// How many bytes are held.
    pub fn bytes(&self) -> usize {
        let numbers = [&self.first_places, &self.indices, &self.places, &self.locations];
        numbers.iter().map(|list| list.capacity() * size_of::<u32>()).sum::<usize>()
            + self.points.capacity() * size_of::<S>()
    }

    /// How many locations there are.
    pub(crate) fn location_count(&self) -> usize {
        self.points.len()
    }

    /// The point at a location.
    #[inline]
    pub(crate) fn point(&self, location: u32) -> &S {
        &self.points[location as usize]
    }

    /// The place of a site; `None` if there is no such site.
    #[inline]
    pub(crate) fn place(&self, index: SiteIndex) -> Option<u32> {
        self.places.get(index.position()).copied()
    }

    /// The location at a place.
    #[inline]
    pub(crate) fn location(&self, place: u32) -> u32 {
        self.locations[place as usize]
    }

    /// The lowest index of the sites at a location that are among the present places; `None` if none of them is.
    #[inline]
    pub(crate) fn first_present(&self, location: u32, present: &Presence) -> Option<SiteIndex> {
        let place = present.next(self.first_places[location as usize] as usize)?;
        let end = self.first_places[location as usize + 1] as usize;
        (place < end).then(|| SiteIndex(self.indices[place]))
    }
}
