/** The view of the arrangement: a line for each generator, a crossing for each tile, a cell for each corner. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import type { Shape } from "../../kit/layer";
import { boxAround, PlaneView } from "../../kit/plane_view";
import { mixed } from "../../kit/zone_colours";
import type { Tiling } from "../../library/pictures";
import type { Vec2, Vec3 } from "../../library/shapes";
import { cellSides, classColour, clipped, inCell } from "./links";
import { stepLit } from "./lighting";
import type { Answers, Lit, State } from "./state";

/** Pixels within which a crossing, and a line, is meant. */
const CROSSING_REACH = 11;
const LINE_REACH = 6;

/** The part of the crossings that the view shows at least: a few may be far away. */
const SHOWN_PART = 0.85;

/** Lines up to which each carries the number of its generator. */
const NAME_LIMIT = 14;

/** Pixels between the end of a line and its name. */
const BESIDE = 7;

/** Pixels from which on a name is far enough from others. */
const ENOUGH = 40;

export function arrangementFigure(control: Control<State>): Figure<State, Answers> {
  let shown: Tiling | null = null;
  const light = (lit: Lit | null) => {
    if (lit?.kind !== control.state.lit?.kind || lit?.index !== control.state.lit?.index)
      control.change({ ...control.state, lit });
  };
  const view = new PlaneView(
    "The arrangement of lines: arrow keys to the left and right go through the crossings, up " +
      "and down through the cells",
    ["cell", "lines", "sweep", "crossings", "names"],
    {
      hovered: (point) => point && shown && light(meant(view, shown, point)),
      pressed: (key) => shown !== null && stepLit(key, shown, control),
    },
    () => control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, { tiling }) {
      shown = tiling;
      if (!tiling) {
        for (const layer of ["cell", "lines", "sweep", "crossings", "names"]) view.draw(layer, []);
        return;
      }
      view.fit(boxAround(shownCrossings(tiling)));
      view.draw("cell", cell(view, tiling, state.lit));
      const names: Shape[] = [];
      const at = sweepPlace(tiling, state.sweep);
      const labels = new Labels(view, at === null || state.isPlain ? null : view.pixel([at, 0])[0]);
      const lines = tiling.classes.flatMap(({ line, generators }, index) => {
        if (!line) return [];
        const lit = isLit(tiling, index, state.lit);
        const drawn = drawLine(view, line, { stroke: classColour(tiling, index), "stroke-width": lit ? 4.5 : 2 });
        if (drawn && tiling.classes.length <= NAME_LIMIT) {
          const { x1, y1, x2, y2 } = drawn.attributes;
          const ends: Vec2[] = [
            [Number(x2), Number(y2)],
            [Number(x1), Number(y1)],
          ];
          names.push(labels.put(ends, generators.map((one) => one + 1).join(", ")));
        }
        return drawn ? [drawn] : [];
      });
      view.draw("lines", lines);
      const sweep =
        at === null || state.isPlain ? null : view.line([at, 0], [0, 1], { class: "sweep", "stroke-width": 3.5 });
      view.draw("sweep", sweep ? [sweep] : []);
      view.draw(
        "crossings",
        tiling.tiles.map((tile, index) => {
          const lit = state.lit?.kind === "tile" && state.lit.index === index;
          const fill = mixed(tile.classes.map((one) => classColour(tiling, one)));
          return view.dot(tile.dual, lit ? 8 : 4.5, {
            fill,
            stroke: lit ? "var(--ink)" : "var(--paper)",
            "stroke-width": lit ? 3 : 1,
          });
        }),
      );
      view.draw("names", names);
    },
  };
}

/** Names at the ends of lines, each at the end that is farther from the sweep and from the names before. */
class Labels {
  private readonly taken: Vec2[] = [];

  constructor(
    private readonly view: PlaneView,
    private readonly sweep: number | null,
  ) {}

  put(ends: readonly Vec2[], name: string): Shape {
    const free = ([x, y]: Vec2) =>
      Math.min(
        this.sweep === null ? Infinity : Math.abs(x - this.sweep),
        ...this.taken.map(([u, v]) => Math.hypot(x - u, y - v)),
      );
    const [first, second] = ends as [Vec2, Vec2];
    const end = Math.min(free(second), ENOUGH) > Math.min(free(first), ENOUGH) ? second : first;
    this.taken.push(end);
    const isRight = end[0] > this.view.width / 2;
    return this.view.text(this.view.point(end), name, { "text-anchor": isRight ? "end" : "start" }, [
      isRight ? -BESIDE : BESIDE,
      4,
    ]);
  }
}

/** The abscissa of L_k: just right of the k-th crossing. */
export function sweepPlace(tiling: Tiling, rank: number): number | null {
  const xs = tiling.tiles.map((tile) => tile.dual[0]);
  if (xs.length === 0) return null;
  const [before, after] = [xs[rank - 1], xs[rank]];
  const gap = ((xs[xs.length - 1] ?? 0) - (xs[0] ?? 0)) / xs.length || 0.5;
  if (before === undefined) return (after ?? 0) - gap / 3;
  if (after === undefined) return before + gap / 3;
  return before + Math.min(after - before, gap) / 2;
}

function shownCrossings(tiling: Tiling): Vec2[] {
  const places = tiling.tiles.map((tile) => tile.dual);
  if (places.length === 0)
    return [
      [-1, -1],
      [1, 1],
    ];
  const middle = (axis: 0 | 1) =>
    places.map((place) => place[axis]).sort((one, other) => one - other)[Math.floor(places.length / 2)] ?? 0;
  const [x, y] = [middle(0), middle(1)];
  const far = (place: Vec2) => Math.hypot(place[0] - x, place[1] - y);
  const near = [...places]
    .sort((one, other) => far(one) - far(other))
    .slice(0, Math.max(1, Math.ceil(places.length * SHOWN_PART)));
  const radius = near.reduce((most, place) => Math.max(most, far(place)), 0) || 1;
  return [...near, [x - radius / 2, y - radius / 2], [x + radius / 2, y + radius / 2]];
}

/** The line a x + b y + c = 0. */
function drawLine(view: PlaneView, [a, b, c]: Vec3, attributes: Shape["attributes"]): Shape | null {
  const size = a * a + b * b;
  if (size === 0) return null;
  return view.line([(-a * c) / size, (-b * c) / size], [b, -a], attributes);
}

function isLit(tiling: Tiling, index: number, lit: Lit | null): boolean {
  if (lit?.kind === "class") return lit.index === index;
  return lit?.kind === "tile" && (tiling.tiles[lit.index]?.classes.includes(index) ?? false);
}

function cell(view: PlaneView, tiling: Tiling, lit: Lit | null): Shape[] {
  if (lit?.kind !== "corner" || !tiling.vertices[lit.index]) return [];
  const frame = [
    [0, 0],
    [view.width, 0],
    [view.width, view.height],
    [0, view.height],
  ] as const;
  const inside = cellSides(tiling, lit.index).reduce<Vec2[]>(
    clipped,
    frame.map((pixel) => view.point(pixel)),
  );
  return inside.length > 2
    ? [view.polygon(inside, { fill: "var(--fill-green)", stroke: "var(--ink)", "stroke-width": 2 })]
    : [];
}

function meant(view: PlaneView, tiling: Tiling, point: Vec2): Lit | null {
  const [px, py] = view.pixel(point);
  const crossing = tiling.tiles.findIndex(({ dual }) => {
    const [x, y] = view.pixel(dual);
    return Math.hypot(x - px, y - py) < CROSSING_REACH;
  });
  if (crossing >= 0) return { kind: "tile", index: crossing };
  const scale = Math.abs(view.pixel([1, 0])[0] - view.pixel([0, 0])[0]);
  const line = tiling.classes.findIndex((one) => {
    if (!one.line) return false;
    const [a, b, c] = one.line;
    return (Math.abs(a * point[0] + b * point[1] + c) / Math.hypot(a, b)) * scale < LINE_REACH;
  });
  if (line >= 0) return { kind: "class", index: line };
  const corner = tiling.vertices.findIndex((_, index) => inCell(cellSides(tiling, index), point));
  return corner >= 0 ? { kind: "corner", index: corner } : null;
}
