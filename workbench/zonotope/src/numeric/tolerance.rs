//! Every named constant of a rounding-error bound, with its derivation.
//!
//! None of these is a tolerance within which two values would be called equal: they bound how far a computed value may
//! be from the exact one, so that a filter knows when its sign is certain. u is [`UNIT`] throughout.

use super::scaling::power_of_two;

/// Half a unit in the last place of 1: |round(x) − x| ≤ UNIT · |x| for every normal result.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// An absolute error that covers every underflow of a computation whose data were scaled to magnitude at most 2.
///
/// One operation that underflows is off by at most 2^-1075. Scaled data carry that error into a handful of products
/// with factors of magnitude below 2^60, which stays far below 2^-960.
pub const UNDERFLOW: f64 = power_of_two(-960);

/// A coordinate of the centre of a zonogon that is larger than this, in the frame in which coordinates have magnitude
/// about 1, is a normal double in the units of the input, where sums of coordinates are: the rounding of pairs of
/// doubles to one is then relative.
pub const SMALLEST_SCALED_CENTER: f64 = power_of_two(-60);

/// The length of a vector below which squares of its coordinates may underflow, so that a length computed from them is
/// worth nothing; above it what underflows is less than a relative 2^-100.
pub(crate) const SHORTEST_LENGTH: f64 = power_of_two(-480);

/// An absolute error that covers the underflow of one product, or of the few products of a dot product.
///
/// Each that underflows is off by at most 2^-1075, so there is room for far more of them than a sum has; a sum of
/// doubles never underflows. The value is large enough that a bound to which it was added is a normal double, and so
/// is the product of two bounds of a bounded product: a processor takes a hundred cycles for one that is not, even in
/// a lane of a vector that nobody reads.
pub const PRODUCT_UNDERFLOW: f64 = power_of_two(-900);

/// Factor by which a bound made of terms that are not negative is multiplied where up to five roundings led to it.
///
/// Rounding takes at most a factor (1 − u) off each time, this multiplication the sixth: (1 − u)^6 (1 + 8 u) > 1.
pub const FIVE_ROUNDINGS: f64 = 1.0 + 8.0 * UNIT;

/// The same where up to thirty roundings led to a bound: (1 − u)^31 (1 + 32 u) > 1 − 500 u² + u > 1.
pub const THIRTY_ROUNDINGS: f64 = 1.0 + 32.0 * UNIT;

/// The same where a bound is a sum over many terms, and where products of two of its relative errors were left out.
///
/// For sums of fewer than 2^31 terms in order, n u < 2^-22: bounds of the form 1 / (1 − n u) are below 1 + n u + 2^-43,
/// and the rounding of the bound, n u as well, stays below 2^-21.
pub const LONG_SUM: f64 = 1.0 + power_of_two(-20);

/// Error of a sum of pairs of doubles, for each of its terms, beside the size of all terms: an addition is within 16 u²
/// of the magnitudes of both operands, neither of which exceeds that size.
pub(crate) const SUM_OF_PAIRS: f64 = 32.0 * UNIT * UNIT;

/// Error of a computed 3 × 3 determinant, beside the sum of the magnitudes of its six products, for data scaled to
/// magnitude below 2.
///
/// Each product goes through five roundings; three more units pay for the roundings within the bound.
pub const DETERMINANT_3X3: f64 = 8.0 * UNIT;

/// Error of a point's height over a plane through three points, computed from rounded differences, beside the sum of
/// the magnitudes of the six products that it is made of.
///
/// Three rounded differences are in each product, which goes through five more roundings; eight more units pay for the
/// roundings within the bound and for products of errors.
pub const HEIGHT_OVER_PLANE: f64 = 16.0 * UNIT;

/// Error of a product of two vectors of rounded coordinates, beside the sum of the magnitudes of its terms, in up to
/// four dimensions.
///
/// Both factors of a term are within 4 ε = 8 u of the exact coordinates
/// ([`Dyadic::to_f64`](super::dyadic::Dyadic::to_f64)) and each term goes through up to seven roundings: 16 u + 7 u,
/// and products of these; 32 u exceeds that and the rounding of the bound.
pub const PRODUCT_OF_ROUNDED_VECTORS: f64 = 32.0 * UNIT;

/// Error of a 3 × 3 determinant of vectors of doubles, beside the product of their lengths |·|_1.
///
/// A term of the determinant goes through five roundings, and the products of coordinates add up to at most the product
/// of the lengths.
pub const DETERMINANT_OF_ROWS: f64 = 8.0 * UNIT;

/// The same for rounded images of vectors under matrices, beside the product of bounds of their lengths: each image is
/// off by at most 4 u times its bound, which takes 12 u of the product, and products of these.
pub const DETERMINANT_OF_IMAGES: f64 = 32.0 * UNIT;

/// A generator whose product with the computed normal of two others is smaller than this part of the product's terms is
/// tried as one of their facet.
///
/// Of exactly coplanar generators the product is off by the roundings of a [determinant](DETERMINANT_OF_ROWS), in terms
/// of numbers that cancel in the normal as well; eight times that finds those of lattices. It decides no answer: a
/// proof is bounded whatever generators take part in it.
pub const FACET_ROUNDING: f64 = 64.0 * UNIT;

/// What the nearest point of a simplex is taken to be off by rounding, beside the longest vertex: sixteen units in the
/// last place.
///
/// Orthogonalising up to seven edges and subtracting from the last vertex takes each coordinate through some thirty
/// roundings, of which about half cancel. It is an estimate and no bound, for a method in floating point whose answers
/// are not proved.
pub const NEAREST_POINT_ROUNDING: f64 = 32.0 * UNIT;

/// Relative error of one operation on numbers of two doubles: 2^-98 = 256 u².
///
/// The algorithms are good to 16 u²; the rest covers that operands are not perfectly normalised and that the bound is
/// taken of a rounded result.
pub const DOUBLE_DOUBLE_OPERATION: f64 = power_of_two(-98);

/// The product of a double vector v with a direction has the sign of v's product with the direction that the latter was
/// rounded from, if it exceeds this times Σ |v_k u_k|: three roundings, and half a unit of each coordinate, with room.
pub(crate) const SIGN_OF_ROUNDED_DIRECTION: f64 = 8.0 * UNIT;

/// Error of a coordinate of a [combined sum](super::combined_sum), in terms of Σ |c v|.
///
/// In units of u² Σ |c v|: what rounding a product leaves behind is off by less than 1. Within a block of 256 vectors,
/// in each of eight lanes, 32 such numbers and 32 remainders of additions, each below u times the sum, are added to a
/// number that stays below 33 u, which takes 32 · 34 = 1,088. Three additions by halves join the lanes, each of numbers
/// below 36 u with a remainder: less than 3 · 72. Remainders of joining the blocks are kept. Together that is less than
/// 2^11. Vectors that are added with signs alone have remainders of additions and no products.
pub(crate) const COMBINED_SUM: f64 = power_of_two(-94);

/// Error of an [absolute sum in pairs](super::lanes) over a block of 512 vectors, in terms of Σ |v|_1 times the largest
/// coordinate of the direction.
///
/// In units of u² times that: the small parts of a vector's product go through roundings that are off by 13. In each of
/// eight lanes, 64 of them and 64 remainders of additions, each below u times the sum, are added to a number that stays
/// below 68 u: 64 · 68 = 4,352. Joining the lanes adds less than 1,100. Together that is less than 2^13.
pub(crate) const SUM_IN_PAIRS: f64 = power_of_two(-92);

/// Factor by which bounds on numbers of two doubles are multiplied: (1 − u)^k (1 + 2^-40) > 1 for every k up to 2^12
/// roundings.
pub const DOUBLE_DOUBLE_BOUND: f64 = 1.0 + power_of_two(-40);

/// Relative error of a difference of two numbers that are each known to a relative 2^-50
/// ([`Dyadic::to_f64`](super::dyadic::Dyadic::to_f64)), beside the sum of their magnitudes: 2^-50 and one rounding,
/// which 2^-48 exceeds.
pub const DIFFERENCE_OF_LEADING_DOUBLES: f64 = power_of_two(-48);

/// Sizes of vectors between which the products of a few of them do not overflow, and their underflow is below the floor
/// of every error bound: 2^-200 and 2^200.
pub const MODERATE_SIZES: std::ops::Range<f64> = power_of_two(-200)..power_of_two(200);

/// Sums of the magnitudes of a matrix's entries between which products with it neither overflow nor lose digits that
/// count: 2^-60 and 2^60.
///
/// Times the larger end, what underflows of vectors of moderate size stays far below the floor of every error bound.
pub const MATRIX_SIZES: std::ops::Range<f64> = power_of_two(-60)..power_of_two(60);

/// Relative error within which a square in pairs of doubles gives its root to within a unit in the last place.
pub(crate) const KNOWN_SQUARE: f64 = power_of_two(-60);

/// Lengths between which no square leaves the range of doubles: 2^-500 and 2^500.
pub const SQUARABLE_SIZES: std::ops::Range<f64> = power_of_two(-500)..power_of_two(500);

/// Sums of lengths between which no product of three lengths leaves the range of doubles: 2^-200 and 2^300.
///
/// A determinant of three vectors is compared with the cube of the lower end, 2^-600, so its underflow never counts.
pub const CUBABLE_SIZES: std::ops::Range<f64> = power_of_two(-200)..power_of_two(300);

/// Coordinates between which the product of two, and the rounding error of that product, are normal doubles: 2^-300 and
/// 2^300, with [`PAIRABLE_EXPONENT`] for the exponent.
pub const PAIRABLE_SIZES: std::ops::Range<f64> =
    power_of_two(-(PAIRABLE_EXPONENT as i32))..power_of_two(PAIRABLE_EXPONENT as i32);

/// The exponent of [`PAIRABLE_SIZES`].
pub const PAIRABLE_EXPONENT: i64 = 300;

/// By how much the computed products of a vector with a cone of directions may be off, in terms of the vector's length
/// and the sum of the lengths that describe the cone.
///
/// A product of two vectors of space goes through three roundings, each within u of |v| times the other factor's
/// length; the rest covers that the lengths are rounded themselves.
pub const CONE_ROUNDING: f64 = 8.0 * UNIT;

/// The gauge counts as known when its error is at most this part of it.
///
/// A gauge that is certified in doubles is usually known to 2^-45 or better. A larger error means that terms of the
/// support function cancelled, and then the exact optimum costs little more than the digits that it gives back.
pub const GAUGE_ACCURACY: f64 = power_of_two(-36);

/// The gauge of an answer that is handed to others is off by at most this part of it: at most four units in the last
/// place.
pub const NEAREST_GAUGE: f64 = 2.0 * f64::EPSILON;

/// Of a quotient that may be larger by this part of it, less is open than the last rounding takes.
pub const NARROW_SLACK: f64 = UNIT / 2.0;

/// The displacement between posed centres counts as known in doubles when no coordinate is off by more than this part
/// of the largest coordinate.
///
/// It is well below [`GAUGE_ACCURACY`], so that what the doubles lack does not count in the gauge.
pub const DISPLACEMENT_ACCURACY: f64 = power_of_two(-50);

/// A vector that is shorter than this part of the longest one contributes less to a sum than rounding that sum to
/// doubles takes off: 2^-64, some digits below the last place of the longest vector.
pub const NEGLIGIBLE_LENGTH: f64 = power_of_two(-64);

/// An angle between directions, in terms of 1, above which a direction that is known to rounding is not believed:
/// bodies that near to each other are separated by a direction that was proved.
pub const CONTACT_ANGLE: f64 = power_of_two(-10);

/// The cone around a separating direction of bodies in near contact that is searched first for the direction of the
/// shortest vector between them: far above the rounding of the separating direction, which mostly is the normal of the
/// face in contact.
pub const SEPARATING_DIRECTION_DOUBT: f64 = power_of_two(-30);

/// The angle by which a direction that was rounded from exact coordinates may be off, in terms of 1, with room for the
/// signs that generators nearly orthogonal to it have for its neighbours: each coordinate is off by at most 2^-50.
pub const EXACT_DIRECTION_ROUNDING: f64 = power_of_two(-44);

/// By how much the product of a vector with a rounded normal, or with the tangent along which it turns, may be off, for
/// coordinates below 2.
///
/// A cross product of two such vectors, rounded and divided by its largest coordinate, of at least 2^-4, is off by at
/// most 2^-45 in each coordinate. Its cross product with a third one is off by at most 2^-42 when it is scaled to a
/// largest coordinate of 1: its length is at least 1 as the factors are orthogonal. Six times that is below 2^-39, and
/// half of the bound is left for the roundings of products and of what they are compared with.
pub const PRODUCT_WITH_TURNED_NORMAL: f64 = power_of_two(-38);

/// The largest coordinate of the cross product of vectors with coordinates below 2 that [`PRODUCT_WITH_TURNED_NORMAL`]
/// takes for granted.
pub const LARGEST_OF_ROUNDED_NORMAL: f64 = power_of_two(-4);

/// Error of each coordinate of a sum over nodes of a tree of directions, beside Σ w of the generators' largest
/// coordinates w.
///
/// A node's own sum is off by at most 2 u w. Sums over nodes keep what rounding leaves behind; six more additions join
/// lanes and totals, and one the sum over the generators that were read.
pub(crate) const NODE_SUM_ROUNDING: f64 = 16.0 * UNIT;

/// Error of the sum of the chords that bound a body of nodes from outside, beside Σ w |u|_1 and the additions.
///
/// With c and r the middle and the half width of the range of x · u over the box of a node, and W and S the sums of w
/// and w x, a chord is (W (r² − c²) + (S · u) c) / r. For |u|_1 = 1, c is off by 3 u, r by 8 u and S · u by 5 u W; the
/// chord changes by at most 4 W times the errors of c and r and by that of S · u: 49 u W. Its own operations round by
/// less than 24 u W.
pub(crate) const CHORD_ROUNDING: f64 = 128.0 * UNIT;

/// What the half sides of a slab of places on a face of the cube are made wider by.
///
/// A place is off by u; middles, slopes times distances and rests of places of magnitude at most 1 are off by less than
/// 2 u each, and less than ten of them lead to a side.
pub(crate) const SLAB_ROUNDING: f64 = 32.0 * UNIT;

/// How far a combination of the rounded sums of nodes, and a displacement rounded twice that they make up, are off,
/// beside Σ w: 6 u for the sums and 4 u for a displacement that is at most 3 Σ w long.
pub(crate) const NODE_BODY_ROUNDING: f64 = 18.0 * UNIT;

/// A point of which this multiple is in the body of the rounded sums of nodes is in the body of the generators, if the
/// gauge of all roundings is below [`NODE_BODY_DOUBT`].
pub(crate) const NODE_BODY_STRETCH: f64 = 1.0 + power_of_two(-30);

/// The gauge of the roundings of a body of nodes for which [`NODE_BODY_STRETCH`] makes up: half of what it adds.
pub(crate) const NODE_BODY_DOUBT: f64 = power_of_two(-31);

/// What the coefficients of the corners of a cell of directions leave of a vector in each coordinate, beside the
/// vector's largest coordinate z.
///
/// The cell is found from quotients with z, which puts a vector off it by 3 u z at most. A place in the cell goes
/// through a product and a difference of at most 2 z, 3 u z, and is cut off at the sides of the cell. Differences of
/// places are off by u z; two of them enter the sum of the coefficients, one the coordinate along a side of at most 2:
/// 4 u z. Together that is 10 u z.
pub(crate) const CORNER_COEFFICIENTS: f64 = 16.0 * UNIT;

/// An angle by which the quaternion (cos φ, sin φ / |a| · a) in doubles is off one of the angle 2 φ, whatever the
/// rounding of φ.
///
/// Sine and cosine of `libm` are within one unit in the last place, 2^-52; the length of the axis and the quotient by
/// it add four roundings of at most 2^-53 each. Half the angle is off by at most the sum, 2^-50.
pub(crate) const ANGLE_ROUNDING: f64 = power_of_two(-48);

/// What rounding half an angle for sine and cosine adds to it, beside the angle: one rounding of a product.
pub(crate) const ANGLE_ROUNDING_OF_A_TURN: f64 = power_of_two(-52);

/// How far the angle of a quaternion that goes linearly between two others is off constant rate, beside tan³ of a
/// quarter of the angle between them: 2 max |x − x³| / 3 = 4 / (9 √3) = 0.2566, rounded up.
pub(crate) const CHORD_OF_A_LINEAR_QUATERNION: f64 = 0.25661;

/// How far a point of a body under a pose in doubles is off the placement of a motion that the pose is rounded from,
/// beside the sum of the magnitudes of what its coordinates are sums of.
///
/// The entries of the matrix are quotients of quaternions with relative errors of some 16 units, by their square; the
/// translation goes through as many roundings.
pub(crate) const POSE_ROUNDING: f64 = 256.0 * UNIT;

/// Error of the vector part of a product of two quaternions, which is as long as the sine of half the angle between
/// them, beside the product of their lengths: four products with two roundings each, and three sums, in each of three
/// coordinates; 16 u, and as much again for the rounding of the bound.
pub(crate) const SINE_OF_QUATERNIONS: f64 = 32.0 * UNIT;

/// Factor by which bounds of the rates and reaches of moving bodies are multiplied, and a share of their sizes that is
/// added: 1 + 2^-30.
///
/// A distance from an axis is a sum of rounded lengths, to which a rounding for each term is added beside this; a cross
/// product is off by 8 u of the size. Rates go through fewer than fifty roundings beside that of the sine,
/// [`SINE_OF_QUATERNIONS`].
pub(crate) const RATE_ROUNDING: f64 = 1.0 + power_of_two(-30);

/// Error of each coefficient of a gap between moving bodies in doubles, beside the sizes of its factors: 2^15 units.
///
/// The derivation is that of the file `motion/continuous/doubles`: magnitudes of 80 times the product of the sizes, of
/// terms that go through at most 300 roundings each, are off by less than 24,000 units; the rest covers what is rounded
/// in the bound and products of errors.
pub(crate) const GAP_ROUNDING: f64 = 32_768.0 * UNIT;

/// Error that a generator adds to such a coefficient, beside the sizes of its factors: it goes through one addition of
/// 512.
pub(crate) const GENERATOR_ROUNDING: f64 = 0.25 * UNIT;

/// By how much the rounded cross product of a direction and a rounded unit vector may be off, beside the direction:
/// the unit vector is off by [`ROUNDED_UNIT_VECTOR`] in each coordinate, which both terms of a coordinate have, and
/// three roundings; three coordinates are added up.
pub(crate) const MARGIN_AXIS_ROUNDING: f64 = 16.0 * ROUNDED_UNIT_VECTOR;

/// The smallest positive double: no number that underflows is off by more.
pub const SMALLEST: f64 = f64::from_bits(1);

/// The part by which a coordinate of a unit vector, and the length that it was divided by, may be off where the exact
/// vector was rounded first: 2^-48.
///
/// The rounded coordinates are off by 2^-50 each, the norm by that and three roundings, the quotient by one more.
pub const ROUNDED_UNIT_VECTOR: f64 = power_of_two(-48);

/// The distance of a rounded point R x − x of a turned point x from the exact one, in terms of the sum of the
/// magnitudes of the coordinates of x: 2^-46.
///
/// Both entries of the matrix are at most 2.1 and off by less than 4 units in the last place, of angles that are off by
/// a unit in the last place of a turn; the products and the sum go through three roundings.
pub const ARC_POINT_ROUNDING: f64 = power_of_two(-46);

/// The distance of such a point from the exact one beside that, where coordinates are next to the smallest double:
/// sixteen of it. Two products in each of two coordinates are off by half of it each; the centre and two sides of a
/// rectangle, scaled back, by half of it each once more.
pub const ARC_POINT_UNDERFLOW: f64 = 16.0 * SMALLEST;

/// Error of a gap between two bounding volumes along a direction of length at most 1, beside the sum of the magnitudes
/// of what it is the sum of: each term goes through fewer than a hundred roundings, 2^-46; four times that.
pub(crate) const NODE_TEST: f64 = power_of_two(-44);

/// Error of a coordinate of a point that a frame of two meshes maps, beside 1 + |s| for a shift s: the entries of the
/// matrix are off by 2^-48, three times that for a coordinate, the shift by 3 · 2^-49, and eight roundings.
pub(crate) const POINT_OF_A_FRAME: f64 = power_of_two(-45);

/// Error of the distance of a pose from a rotation as it is computed: four roundings of sums of at most 4.
pub(crate) const POSE_OF_A_FRAME: f64 = power_of_two(-50);

/// The part by which a frame of two meshes changes distances: its first pose is no farther from a rotation than 1e-12,
/// which takes or adds three times that.
pub(crate) const DISTANCE_OF_A_FRAME: f64 = power_of_two(-36);

/// The part that makes up for the rounding of a radius: three differences, three squares, two sums and a root.
pub(crate) const ROUNDED_RADIUS: f64 = power_of_two(-48);

/// Error of a coordinate of an exact place that is rounded in units in which it is at most 1: a part of 2^-50 and a
/// denormal step.
pub(crate) const ROUNDED_IMAGE: f64 = power_of_two(-49);

/// Error of a distance of two triangles in doubles, beside the largest magnitude of a coordinate: displacements and
/// heights go through fewer than fifty roundings of three coordinates each.
pub(crate) const TRIANGLE_DISTANCE: f64 = power_of_two(-44);

/// The half-length of the cube that is added to a zonotope fitted in doubles, in units of its mesh. It decides no
/// answer: the points are proved to be inside, or the cube is made larger.
pub(crate) const FITTED_MARGIN: f64 = power_of_two(-40);
