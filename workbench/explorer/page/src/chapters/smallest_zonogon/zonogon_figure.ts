/** The figure of Z(O): the points, their reflections, the zonogon between them, and the lines ℓ_t. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import type { Shape } from "../../kit/layer";
import { boxAround, PlaneView, type PlaneHandle } from "../../kit/plane_view";
import { add2, place2, scale2, sub2, tidy2 } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import { direction, pointName, reach, type Answers, type State } from "./state";

/** Points up to which every point is a handle; above it only the hull's vertices are. */
const HANDLE_LIMIT = 60;

/** Points up to which they carry their names. */
const NAME_LIMIT = 16;

/** The part of the reach at which the handle of the line sits. */
const TURN_AT = 0.45;

export function zonogonFigure(control: Control<State>): Figure<State, Answers> {
  const moved = (id: string, point: Vec2, finished: boolean) => {
    const state = control.state;
    const put = finished ? control.commit : control.change;
    if (id === "O") return put({ ...state, center: tidy2(point) });
    if (id === "turn") {
      const [x, y] = sub2(point, state.center);
      return put({ ...state, turn: Math.round((Math.atan2(y, x) * 180) / Math.PI) });
    }
    const index = Number(id);
    put({ ...state, points: state.points.map((one, place) => (place === index ? tidy2(point) : one)) });
  };
  const view = new PlaneView(
    "The points, their reflections through O, and the zonogon Z(O)",
    ["levels", "lines", "hulls", "runs", "marks", "names"],
    {
      moved,
      removed: (id) => {
        const { state } = control;
        if (state.points.length < 2) return;
        control.commit({ ...state, points: state.points.filter((_, place) => place !== Number(id)) });
      },
      added: (point) => control.commit({ ...control.state, points: [...control.state.points, tidy2(point)] }),
      pressed: (key) => {
        if (key !== "a" && key !== "A") return false;
        const middle = tidy2(view.point([view.width / 2, view.height / 2]));
        control.commit({ ...control.state, points: [...control.state.points, middle] });
        return true;
      },
    },
    () => control.redraw(),
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, answers) {
      const { boundary, hull, lines } = answers.zonogon;
      const reflect = (point: Vec2): Vec2 => sub2(scale2(state.center, 2), point);
      view.fit(boxAround([...state.points, ...boundary.map((one) => one.point)]));
      const levels = answers.late?.levels ?? [];
      view.draw(
        "levels",
        state.levels ? [...levels].reverse().map((level) => view.polygon(level, { class: "level" })) : [],
      );
      const onBoundary = new Set(boundary.map((one, place) => edgeName(one, boundary[(place + 1) % boundary.length])));
      view.draw("lines", lineShapes(view, lines, hull, onBoundary));
      const corners = hull.map((index) => state.points[index] as Vec2);
      view.draw("hulls", [
        view.polygon(corners, { class: "hull" }),
        view.polygon(corners.map(reflect), { class: "reflection" }),
      ]);
      view.draw("runs", runShapes(view, boundary));
      const through = view.line(state.center, direction(state.turn), { class: "sweep dashed", "stroke-width": 1.5 });
      const marks = corners.map((corner) => view.dot(reflect(corner), 4, { class: "reflected-point" }));
      const inner =
        state.points.length > HANDLE_LIMIT
          ? state.points.map((point) => view.dot(point, 1.6, { fill: "var(--blue)" }))
          : [];
      view.draw("marks", [...(through ? [through] : []), ...inner, ...marks]);
      const named = state.points.length <= NAME_LIMIT;
      const names = hull.map((index) =>
        view.text(reflect(state.points[index] as Vec2), `${pointName(index)}′`, { class: "quiet" }, [7, 15]),
      );
      view.draw("names", named ? names : []);
      const movable = state.points.length > HANDLE_LIMIT ? hull : state.points.map((_, index) => index);
      const handles: PlaneHandle[] = movable.map((index) => ({
        id: String(index),
        at: state.points[index] as Vec2,
        label: `Point ${index + 1} at ${place2(state.points[index] as Vec2)}`,
        look: "point",
        removable: true,
        ...(named ? { name: pointName(index) } : {}),
      }));
      const turning = add2(state.center, scale2(direction(state.turn), TURN_AT * reach(state)));
      handles.push(
        { id: "turn", at: turning, label: `The line through O, turned by ${state.turn} degrees`, look: "turn" },
        { id: "O", at: state.center, label: `The centre O at ${place2(state.center)}`, look: "center", name: "O" },
      );
      view.drawHandles(handles);
    },
  };
}

type Vertex = Answers["zonogon"]["boundary"][number];

/** An edge of the hull as the two points between which it lies; empty for other edges. */
function edgeName(from: Vertex, to: Vertex | undefined): string {
  return to && from.reflected === to.reflected && !from.reflected ? `${from.source}-${to.source}` : "";
}

function lineShapes(
  view: PlaneView,
  lines: Answers["zonogon"]["lines"],
  hull: readonly number[],
  on: ReadonlySet<string>,
): Shape[] {
  return lines.flatMap(([one, other], edge) => {
    const lit = on.has(`${hull[edge]}-${hull[(edge + 1) % hull.length]}`);
    const shape = view.line(one, sub2(other, one), { class: lit ? "thin good" : "thin dashed" });
    return shape ? [shape] : [];
  });
}

/** The edges of Z(O): those of the hull, those of its reflection, and those between the two. */
function runShapes(view: PlaneView, boundary: readonly Vertex[]): Shape[] {
  return boundary.map((vertex, place) => {
    const next = boundary[(place + 1) % boundary.length] as Vertex;
    const look = vertex.reflected !== next.reflected ? "bridge" : vertex.reflected ? "run reflected" : "run";
    return view.path([vertex.point, next.point], { class: look });
  });
}
