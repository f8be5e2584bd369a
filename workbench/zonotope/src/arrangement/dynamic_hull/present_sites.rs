//! The sites that are present, by their locations.

use std::sync::Arc;

use super::interface::{Side, UpdateError};
use super::sites::presence::Presence;
use super::sites::{Site, SiteIndex, SortedSites};

/// The present sites, and which of their chains is asked for.
#[derive(Debug, Clone)]
pub(super) struct PresentSites<S> {
    pub(super) sites: Arc<SortedSites<S>>,
    pub(super) side: Side,
    /// By place.
    present: Presence,
}

/// The location that a tangent touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LocationTangent {
    /// At a location.
    Touches(u32),
    /// [`Tangent::Unbounded`].
    Unbounded,
    /// [`Tangent::Hidden`].
    Hidden,
}

impl<S: Site> PresentSites<S> {
    /// No sites but those of `present`.
    pub(super) fn new(
        sites: Arc<SortedSites<S>>,
        side: Side,
        present: impl IntoIterator<Item = SiteIndex>,
    ) -> Result<Self, UpdateError> {
        let mut all = Self { present: Presence::new(sites.len()), sites, side };
        for site in present {
            all.insert(site)?;
        }
        Ok(all)
    }

    fn place(&self, site: SiteIndex) -> Result<u32, UpdateError> {
        self.sites.place(site).ok_or(UpdateError::Unknown { site, count: self.sites.len() })
    }

    /// Makes a site present; its location if that had none.
    pub(super) fn insert(&mut self, site: SiteIndex) -> Result<Option<u32>, UpdateError> {
        let place = self.place(site)?;
        let location = self.sites.location(place);
        let was_vacant = !self.is_occupied(location);
        if self.present.insert(place as usize) {
            Ok(was_vacant.then_some(location))
        } else {
            Err(UpdateError::Present(site))
        }
    }

    /// Makes a site absent; its location if that has none any more.
    pub(super) fn delete(&mut self, site: SiteIndex) -> Result<Option<u32>, UpdateError> {
        let place = self.place(site)?;
        let location = self.sites.location(place);
        if self.present.remove(place as usize) {
            Ok((!self.is_occupied(location)).then_some(location))
        } else {
            Err(UpdateError::Absent(site))
        }
    }

    /// Whether a site is present at a location.
    fn is_occupied(&self, location: u32) -> bool {
        self.sites.first_present(location, &self.present).is_some()
    }

    /// Whether a site is present.
    pub(super) fn contains(&self, site: SiteIndex) -> bool {
        self.sites.place(site).is_some_and(|place| self.present.contains(place as usize))
    }

    /// The number of sites that are present.
    pub(super) fn len(&self) -> usize {
        self.present.len()
    }

    /// The bytes that are held.
    pub(super) fn bytes(&self) -> usize {
        self.sites.bytes() + self.present.bytes()
    }

    /// Whether any site is present.
    pub(super) fn has_any(&self) -> bool {
        self.present.len() > 0
    }

    /// The lowest index of the sites at a location, which is occupied.
    pub(super) fn index(&self, location: u32) -> SiteIndex {
        self.sites.first_present(location, &self.present).expect("a chain has no vertex where no site is present")
    }

    /// The occupied locations from left to right.
    pub(super) fn locations(&self) -> impl Iterator<Item = u32> {
        let mut last = None;
        let all = self.present.members_from(0).map(|place| self.sites.location(place as u32));
        all.filter(move |&location| last.replace(location) != Some(location))
    }

    /// The point at a location.
    #[inline]
    pub(super) fn point(&self, location: u32) -> &S {
        self.sites.point(location)
    }
}
