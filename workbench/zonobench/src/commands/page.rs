//! The page of a picture that a command draws: a panel as high as its content, a legend below.

use figures::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use figures::scene::{LegendEntry, Panel, Scene};

const WIDTH: f64 = 760.0;
/// The least and the greatest height of the panel.
const HEIGHTS: [f64; 2] = [160.0, 560.0];
const MARGIN: f64 = 24.0;

/// More points or vertices than this are thinned out.
const DRAWN_POINT_LIMIT: usize = 4000;

/// A page with room for a legend of some rows.
pub(super) struct Page {
    scene: Scene,
    panel: PageBox,
    world: WorldBox,
}

impl Page {
    /// A page whose panel shows `world`.
    pub(super) fn new(world: WorldBox, legend_rows: usize, title: &str, description: &str) -> Self {
        let width = WIDTH - 2.0 * MARGIN;
        let height = height_for(&world, width);
        let legend = 12.0 + 22.0 * legend_rows as f64;
        let scene = Scene::new(WIDTH, height + 2.0 * MARGIN + legend, title, description);
        Self { scene, panel: PageBox::new(MARGIN, MARGIN, width, height), world }
    }

    /// The panel, to be drawn in.
    pub(super) fn panel(&mut self) -> Panel<'_> {
        let frame = Frame::fit(&self.world, self.panel);
        Panel::new(&mut self.scene, frame)
    }

    /// The panel with its margin: where lines end that have no end.
    pub(super) fn window(&self) -> PageBox {
        self.panel.inset(-MARGIN / 2.0)
    }

    /// Writes the legend and the document.
    pub(super) fn finish(mut self, legend: &[LegendEntry<'_>]) -> String {
        let place = PagePoint::new(MARGIN, self.panel.max.y + MARGIN);
        self.scene.legend(place, self.panel.width(), legend);
        self.scene.finish()
    }
}

/// Few enough of the items, evenly.
pub(super) fn thinned<T>(items: impl IntoIterator<IntoIter: ExactSizeIterator<Item = T>>) -> impl Iterator<Item = T> {
    let items = items.into_iter();
    let stride = stride(items.len());
    items.step_by(stride)
}

/// One of how many items is kept.
pub(super) fn stride(count: usize) -> usize {
    count.div_ceil(DRAWN_POINT_LIMIT).max(1)
}

/// The height at which the world fills the width, within limits; computed on halves, which do not overflow.
fn height_for(world: &WorldBox, width: f64) -> f64 {
    let half = |axis: usize| world.max[axis] / 2.0 - world.min[axis] / 2.0;
    let height = width * (half(1) / half(0));
    if height.is_nan() { HEIGHTS[0] } else { height.clamp(HEIGHTS[0], HEIGHTS[1]) }
}
