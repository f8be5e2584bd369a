/** The figures of the chapter: points in their zonogons, and the dual zonogon in the unit circle. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { boxAround, PlaneView, type PlaneHandle } from "../../kit/plane_view";
import { add2, place2, scale2, sub2, tidy2 } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import { directionsOf, type Answers, type State } from "./state";

/** Points up to which each is a handle. */
const HANDLE_LIMIT = 60;

export function alongFigure(control: Control<State>): Figure<State, Answers> {
  const view = pointsView(control, "The points, and the shortest zonogon along the directions");
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, { along, alongOutline }) {
      view.fit(boxAround([...state.points, ...alongOutline]));
      const center = along.center ?? state.points[0] ?? [0, 0];
      const rays = directionsOf(state).map((one) => view.line(center, one, { class: "thin dashed" }));
      view.draw("outline", [
        ...rays.filter((ray) => ray !== null),
        view.polygon(alongOutline, { class: "run", fill: "var(--fill-blue)", "stroke-width": 2.5 }),
      ]);
      const parts = directionsOf(state).map((one, index) => scale2(one, along.coefficients?.[index] ?? 0));
      view.draw(
        "generators",
        parts.map((part) => view.path([sub2(center, part), add2(center, part)], { class: "good", "stroke-width": 3 })),
      );
      drawPoints(view, state);
    },
  };
}

export function fewFigure(control: Control<State>): Figure<State, Answers> {
  const view = pointsView(control, "The points, the shortest zonogon, and the one of few generators");
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, { all, allOutline, fewOutline, few }) {
      view.fit(boxAround([...state.points, ...allOutline, ...fewOutline]));
      view.draw("outline", [
        view.polygon(fewOutline, { class: "run reflected", "stroke-width": 2.5 }),
        view.polygon(allOutline, { class: "run", fill: "var(--fill-blue)", "stroke-width": 2 }),
      ]);
      view.draw("generators", [
        view.dot(all.result.center, 5, { fill: "var(--blue)" }),
        view.dot(few.center, 5, { fill: "var(--red)" }),
      ]);
      drawPoints(view, state);
    },
  };
}

export function dualFigure(control: Control<State>): Figure<State, Answers> {
  const view = new PlaneView("The zonogon of the forces in the unit circle", ["circle", "dual", "names"], {}, () =>
    control.redraw(),
  );
  const circle = Array.from(
    { length: 181 },
    (_, index): Vec2 => [Math.cos((index * Math.PI) / 90), Math.sin((index * Math.PI) / 90)],
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(_, { dual }) {
      view.fit({ low: [-1, -1], high: [1, 1] });
      view.draw("circle", [view.path(circle, { class: "best" })]);
      const sizes = dual.map(([x, y]) => Math.hypot(x, y));
      const farthest = dual[sizes.indexOf(Math.max(...sizes))];
      view.draw("dual", [
        view.polygon(dual, { fill: "var(--fill-green)", stroke: "var(--green)", "stroke-width": 2 }),
        ...(farthest ? [view.dot(farthest, 6, { fill: "var(--red)" })] : []),
      ]);
      view.draw("names", farthest ? [view.text(farthest, "farthest vertex", { class: "quiet" }, [9, -9])] : []);
    },
  };
}

function pointsView(control: Control<State>, label: string): PlaneView {
  return new PlaneView(
    label,
    ["outline", "generators", "dots"],
    {
      moved: (id, point, finished) => {
        const points = control.state.points.map((one, place) => (String(place) === id ? tidy2(point) : one));
        (finished ? control.commit : control.change)({ ...control.state, points });
      },
      removed: (id) => {
        const { state } = control;
        if (state.points.length > 1)
          control.commit({ ...state, points: state.points.filter((_, place) => String(place) !== id) });
      },
      added: (point) => control.commit({ ...control.state, points: [...control.state.points, tidy2(point)] }),
    },
    () => control.redraw(),
  );
}

function drawPoints(view: PlaneView, { points }: State): void {
  if (points.length > HANDLE_LIMIT) {
    view.draw(
      "dots",
      points.map((point) => view.dot(point, 2, { fill: "var(--blue)" })),
    );
    view.drawHandles([]);
    return;
  }
  const handles = points.map(
    (at, index): PlaneHandle => ({
      id: String(index),
      at,
      label: `Point ${index + 1} at ${place2(at)}`,
      look: "point",
      removable: true,
    }),
  );
  view.drawHandles(handles);
}
