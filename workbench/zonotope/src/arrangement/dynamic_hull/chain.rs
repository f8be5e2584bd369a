//! A chain with the sites that are present: what all methods but the twin have in common.

use std::sync::Arc;

use super::interface::{HullChain, Side, Tangent, Towards, UpdateError};
use super::sites::presence::Presence;
use super::sites::{Direction, Site, SiteIndex, SortedSites};

/// The present sites, and which of their chains is asked for.
#[derive(Debug, Clone)]
pub struct PresentSites<S> {
    pub(super) sites: Arc<SortedSites<S>>,
    pub(super) side: Side,
    /// By place.
    present: Presence,
}

/// Where a tangent touches the locations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LocationTangent {
    /// At a location.
    Touches(u32),
    /// [`Tangent::Unbounded`].
    Unbounded,
    /// [`Tangent::Hidden`].
    Hidden,
}

/// A method that keeps one chain of the locations at which a site is present.
pub trait ChainMethod<S> {
    /// The chain of the sites that are present.
    fn build(sites: &PresentSites<S>) -> Self;

    /// A location has its first site.
    fn occupy(&mut self, sites: &PresentSites<S>, location: u32);

    /// A location has lost its last site.
    fn vacate(&mut self, sites: &PresentSites<S>, location: u32);

    /// [`HullChain::extreme`] among locations.
    fn extreme(&self, sites: &PresentSites<S>, direction: Direction) -> Option<u32>;

    /// [`HullChain::tangent`] to locations.
    fn tangent(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent;

    /// [`HullChain::vertices`] among locations.
    fn vertices(&self, sites: &PresentSites<S>) -> Vec<u32>;

    /// How many bytes are held beside the sites.
    fn bytes(&self) -> usize;
}

/// One chain of the convex hull of the present sites, kept by a method.
#[derive(Debug, Clone)]
pub struct Chain<S, M> {
    sites: PresentSites<S>,
    method: M,
}

impl<S: Site> PresentSites<S> {
    /// No sites but those of `present`.
    fn new(
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
    fn insert(&mut self, site: SiteIndex) -> Result<Option<u32>, UpdateError> {
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
    fn delete(&mut self, site: SiteIndex) -> Result<Option<u32>, UpdateError> {
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

    /// Whether any site is present.
    pub(super) fn has_any(&self) -> bool {
        self.present.len() > 0
    }

    /// The lowest index of the sites at a location, which is occupied.
    fn index(&self, location: u32) -> SiteIndex {
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

impl<S: Site, M: ChainMethod<S>> Chain<S, M> {
    /// The chain on one side of some of the sites. O(n) after the sites are sorted.
    ///
    /// # Errors
    /// [`UpdateError`] if an index of `present` is repeated or unknown.
    pub fn new(
        sites: Arc<SortedSites<S>>,
        side: Side,
        present: impl IntoIterator<Item = SiteIndex>,
    ) -> Result<Self, UpdateError> {
        let sites = PresentSites::new(sites, side, present)?;
        Ok(Self { method: M::build(&sites), sites })
    }
}

impl<S: Site, M: ChainMethod<S>> HullChain<S> for Chain<S, M> {
    fn insert(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        if let Some(location) = self.sites.insert(site)? {
            self.method.occupy(&self.sites, location);
        }
        Ok(())
    }

    fn delete(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        if let Some(location) = self.sites.delete(site)? {
            self.method.vacate(&self.sites, location);
        }
        Ok(())
    }

    fn contains(&self, site: SiteIndex) -> bool {
        self.sites.sites.place(site).is_some_and(|place| self.sites.present.contains(place as usize))
    }

    fn len(&self) -> usize {
        self.sites.present.len()
    }

    fn extreme(&self, direction: Direction) -> Option<SiteIndex> {
        Some(self.sites.index(self.method.extreme(&self.sites, direction)?))
    }

    fn tangent(&self, from: &S, towards: Towards) -> Tangent {
        match self.method.tangent(&self.sites, from, towards) {
            LocationTangent::Touches(location) => Tangent::Touches(self.sites.index(location)),
            LocationTangent::Unbounded => Tangent::Unbounded,
            LocationTangent::Hidden => Tangent::Hidden,
        }
    }

    fn vertices(&self) -> Vec<SiteIndex> {
        self.method.vertices(&self.sites).into_iter().map(|location| self.sites.index(location)).collect()
    }

    fn bytes(&self) -> usize {
        self.sites.sites.bytes() + self.sites.present.bytes() + self.method.bytes()
    }
}
