//! Places on the page, and the map from the world to them.

/// A place on the page: y grows downwards, one unit is one CSS pixel at natural size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PagePoint {
    /// From the left edge.
    pub x: f64,
    /// From the top edge.
    pub y: f64,
}

impl PagePoint {
    /// The place with these coordinates.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// This place moved by `(dx, dy)`.
    pub const fn moved(self, dx: f64, dy: f64) -> Self {
        Self::new(self.x + dx, self.y + dy)
    }
}

/// An upright rectangle on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PageBox {
    /// The corner with the smallest coordinates.
    pub min: PagePoint,
    /// The corner with the largest coordinates.
    pub max: PagePoint,
}

impl PageBox {
    /// The rectangle with its upper left corner at `(x, y)`.
    pub const fn new(x: f64, y: f64, width: f64, height: f64) -> Self {
        Self { min: PagePoint::new(x, y), max: PagePoint::new(x + width, y + height) }
    }

    /// Its width.
    pub const fn width(&self) -> f64 {
        self.max.x - self.min.x
    }

    /// Its height.
    pub const fn height(&self) -> f64 {
        self.max.y - self.min.y
    }

    /// Its middle.
    pub const fn center(&self) -> PagePoint {
        PagePoint::new((self.min.x + self.max.x) / 2.0, (self.min.y + self.max.y) / 2.0)
    }

    /// The rectangle with `margin` taken off (or, if negative, put on) at every side.
    pub const fn inset(&self, margin: f64) -> Self {
        Self { min: self.min.moved(margin, margin), max: self.max.moved(-margin, -margin) }
    }

    /// Whether a place lies in the rectangle or on its edge.
    pub fn holds(&self, place: PagePoint) -> bool {
        (self.min.x..=self.max.x).contains(&place.x) && (self.min.y..=self.max.y).contains(&place.y)
    }

    /// The area that two rectangles share.
    pub fn shared_area(&self, other: &Self) -> f64 {
        let width = self.max.x.min(other.max.x) - self.min.x.max(other.min.x);
        let height = self.max.y.min(other.max.y) - self.min.y.max(other.min.y);
        width.max(0.0) * height.max(0.0)
    }

    /// The area of this rectangle that lies outside of `frame`.
    pub fn area_outside(&self, frame: &Self) -> f64 {
        self.width() * self.height() - self.shared_area(frame)
    }

    /// The part of the segment inside of the rectangle, if any (Liang and Barsky's parameters).
    pub fn clip(&self, from: PagePoint, to: PagePoint) -> Option<(PagePoint, PagePoint)> {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (step, room) in [
            (-dx, from.x - self.min.x),
            (dx, self.max.x - from.x),
            (-dy, from.y - self.min.y),
            (dy, self.max.y - from.y),
        ] {
            if step == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if step < 0.0 {
                enter = enter.max(room / step);
            } else {
                leave = leave.min(room / step);
            }
        }
        (enter <= leave).then(|| (from.moved(enter * dx, enter * dy), from.moved(leave * dx, leave * dy)))
    }
}

/// The smallest upright rectangle `[min, max]` of the world around points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldBox {
    /// The smallest coordinates.
    pub min: [f64; 2],
    /// The largest coordinates.
    pub max: [f64; 2],
}

impl WorldBox {
    /// The box around all points; of no points, the unit square.
    pub fn around<'a>(points: impl IntoIterator<Item = &'a [f64; 2]>) -> Self {
        let mut points = points.into_iter();
        let Some(&first) = points.next() else {
            return Self { min: [0.0, 0.0], max: [1.0, 1.0] };
        };
        points.fold(Self { min: first, max: first }, |around, point| Self {
            min: [around.min[0].min(point[0]), around.min[1].min(point[1])],
            max: [around.max[0].max(point[0]), around.max[1].max(point[1])],
        })
    }

    /// The box with `part` of its larger side put on at every side.
    pub fn grown(&self, part: f64) -> Self {
        let margin = part * (self.max[0] - self.min[0]).max(self.max[1] - self.min[1]);
        Self { min: [self.min[0] - margin, self.min[1] - margin], max: [self.max[0] + margin, self.max[1] + margin] }
    }

    fn center(&self) -> [f64; 2] {
        [self.min[0] / 2.0 + self.max[0] / 2.0, self.min[1] / 2.0 + self.max[1] / 2.0]
    }
}

/// The map from the world (y up) to a rectangle of the page (y down): equal scales, except for a stated stretch of x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    page: PageBox,
    world_center: [f64; 2],
    scale: [f64; 2],
}

impl Frame {
    /// Fits `world` into `page`, centred, with equal scales in x and y.
    pub fn fit(world: &WorldBox, page: PageBox) -> Self {
        Self::fit_stretched(world, page, 1.0)
    }

    /// Fits `world` into `page`, centred, where one unit of x is `stretch` times as long as one of y.
    ///
    /// The factors are computed on halves, so that a world as large as the double range still fits; a world without
    /// extent is drawn at its own size.
    pub fn fit_stretched(world: &WorldBox, page: PageBox, stretch: f64) -> Self {
        let half_width = (world.max[0] / 2.0 - world.min[0] / 2.0) * stretch;
        let half_height = world.max[1] / 2.0 - world.min[1] / 2.0;
        let room = |page: f64, half: f64| {
            if half > 0.0 { page / 2.0 / half } else { f64::INFINITY }
        };
        let scale = room(page.width(), half_width).min(room(page.height(), half_height));
        let scale = if scale.is_finite() { scale } else { 1.0 };
        Self { page, world_center: world.center(), scale: [scale * stretch, scale] }
    }

    /// The rectangle that it fills.
    pub const fn page(&self) -> &PageBox {
        &self.page
    }

    /// The place of a point of the world on the page.
    pub fn place(&self, point: [f64; 2]) -> PagePoint {
        let middle = self.page.center();
        PagePoint::new(
            middle.x + self.scale[0] * (point[0] - self.world_center[0]),
            middle.y - self.scale[1] * (point[1] - self.world_center[1]),
        )
    }

    /// The point of the world that lies at a place on the page.
    pub fn world_at(&self, place: PagePoint) -> [f64; 2] {
        let middle = self.page.center();
        [
            self.world_center[0] + (place.x - middle.x) / self.scale[0],
            self.world_center[1] - (place.y - middle.y) / self.scale[1],
        ]
    }
}

/// A page coordinate with three decimals, without trailing zeros and without a negative zero.
pub fn decimals(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_fixed_and_short() {
        assert_eq!(decimals(0.0), "0");
        assert_eq!(decimals(-0.0001), "0");
        assert_eq!(decimals(100.0), "100");
        assert_eq!(decimals(1.0005), "1");
        assert_eq!(decimals(-12.3456), "-12.346");
    }

    #[test]
    fn frame_maps_corners_and_back() {
        let world = WorldBox { min: [0.0, 0.0], max: [2.0, 1.0] };
        let frame = Frame::fit(&world, PageBox::new(10.0, 20.0, 200.0, 200.0));
        assert_eq!(frame.place([0.0, 0.0]), PagePoint::new(10.0, 170.0));
        assert_eq!(frame.place([2.0, 1.0]), PagePoint::new(210.0, 70.0));
        assert_eq!(frame.world_at(PagePoint::new(210.0, 70.0)), [2.0, 1.0]);
    }

    #[test]
    fn frame_survives_the_whole_double_range() {
        let world = WorldBox { min: [-f64::MAX, -f64::MAX], max: [f64::MAX, f64::MAX] };
        let frame = Frame::fit(&world, PageBox::new(0.0, 0.0, 100.0, 100.0));
        let corner = frame.place([f64::MAX, f64::MAX]);
        assert!(corner.x.is_finite() && corner.y.is_finite());
        let point = Frame::fit(&WorldBox::around(&[[3.0, 4.0]]), PageBox::new(0.0, 0.0, 100.0, 100.0));
        assert_eq!(point.place([3.0, 4.0]), PagePoint::new(50.0, 50.0));
    }

    #[test]
    fn clip_keeps_the_inside() {
        let page = PageBox::new(0.0, 0.0, 10.0, 10.0);
        let kept = page.clip(PagePoint::new(-5.0, 5.0), PagePoint::new(15.0, 5.0));
        assert_eq!(kept, Some((PagePoint::new(0.0, 5.0), PagePoint::new(10.0, 5.0))));
        assert_eq!(page.clip(PagePoint::new(-5.0, 11.0), PagePoint::new(15.0, 11.0)), None);
    }
}
