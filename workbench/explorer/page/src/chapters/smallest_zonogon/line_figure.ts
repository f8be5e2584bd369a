/** The figure of f along the line through O: piecewise linear, and bent upwards wherever the line crosses an ℓ_t. */

import type { Control, Figure } from "../../kit/chapter";
import { standalone } from "../../kit/downloads";
import { PlaneView } from "../../kit/plane_view";
import { add2, digits, scale2, tidy2 } from "../../kit/vectors";
import type { Vec2 } from "../../library/shapes";
import { direction, reach, type Answers, type State } from "./state";

export function lineFigure(control: Control<State>): Figure<State, Answers> {
  let begun: State | null = null;
  const view = new PlaneView(
    "The area f of Z(O) while O moves along the line",
    ["axes", "graph", "marks", "names"],
    {
      // The line stays where it is while O is pulled along it.
      moved: (_, point, finished) => {
        begun ??= control.state;
        const { center, turn } = begun;
        const next = { ...control.state, center: tidy2(add2(center, scale2(direction(turn), point[0]))) };
        if (finished) begun = null;
        (finished ? control.commit : control.change)(next);
      },
    },
    () => control.redraw(),
    true,
  );
  return {
    element: view.element,
    svg: () => standalone(view.svg),
    draw(state, answers) {
      const { at, area } = answers.line;
      const far = reach(state);
      const moved = begun ? shift(begun, state) : 0;
      const place = (part: number): number => (2 * part - 1) * far + moved;
      const track = at.map((part, index): Vec2 => [place(part), area[index] ?? 0]);
      const high = Math.max(...area);
      const least = Number(answers.best.result.area);
      view.frame({ low: [-far, least], high: [far, Math.max(high, least + 1e-9)] });
      const best = view.line([0, least], [1, 0], { class: "best" });
      view.draw("axes", best ? [best] : []);
      view.draw("graph", [view.path(track, { class: "graph" })]);
      view.draw(
        "marks",
        track.slice(1, -1).map((point) => view.dot(point, 3, { fill: "var(--green)" })),
      );
      view.draw("names", [
        view.text([-far, least], `least area ${digits(least)}`, { class: "quiet" }, [0, 16]),
        view.text([-far, high], `f up to ${digits(high)}`, { class: "quiet" }, [0, 0]),
        view.text([far, least], "along the line →", { class: "quiet", "text-anchor": "end" }, [0, 16]),
      ]);
      view.drawHandles([
        {
          id: "along",
          at: [moved, answers.zonogon.area],
          label: `O on its line; the area of Z(O) is ${digits(answers.zonogon.area)}`,
          look: "center",
          name: "O",
        },
      ]);
    },
  };
}

/** How far O has been pulled along the line, in its direction. */
function shift(begun: State, state: State): number {
  const [x, y] = direction(begun.turn);
  return (state.center[0] - begun.center[0]) * x + (state.center[1] - begun.center[1]) * y;
}
