/** The steps of the rival: the vertices that it has found, and the point of their simplex nearest to the question's. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { Stepper } from "../../kit/stepper";
import { add3, digits, length3, place3 } from "../../kit/vectors";
import type { Belief } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import type { Answers, State } from "./state";

const OPACITY = 0.3;

export function rivalFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("The steps of the rival", {});
  const solid = new Solid();
  view.put("body", solid);
  const stepper = new Stepper("Steps of the rival", (rivalStep) => control.commit({ ...control.state, rivalStep }));
  return {
    element: html("div", {}, view.element, stepper.element),
    svg: () => view.svg(),
    draw(state, { belief, sum }) {
      if (!belief || !sum) {
        solid.clear();
        view.draw([]);
        stepper.draw(0, 1, "The body has too many generators to be drawn.");
        return;
      }
      const colours = sum.facets.map(() => "#7a8794");
      solid.draw(solidOf(sum), { facets: colours, opacity: OPACITY, edge: "#7a8794" });
      view.fit([state.point, ...sum.vertices]);
      const now = Math.min(state.rivalStep, belief.steps.length - 1);
      const seen = belief.steps.slice(0, now + 1);
      // The rival shifts the body so that the point is the origin; the picture shifts it back.
      const placed = (place: Vec3): Vec3 => add3(place, state.point);
      const nearest = seen.flatMap((step) => (step.nearest ? [placed(step.nearest)] : []));
      const vertices = seen.map((step) => placed(step.vertex));
      const last = nearest[nearest.length - 1];
      view.draw(
        [],
        [
          { at: state.point, text: "p", dot: "var(--red)" },
          ...vertices.map((at, index) => ({ at, text: String(index + 1), dot: "var(--ink)" })),
        ],
        [
          { points: vertices, look: "thin" },
          { points: nearest, look: "best" },
          ...(last ? [{ points: [last, state.point], look: "sweep" }] : []),
        ],
      );
      stepper.draw(now, belief.steps.length, told(belief, now));
    },
  };
}

function told({ belief, steps }: Belief, now: number): string {
  const step = steps[now];
  if (!step) return "";
  const begin = `Step ${now + 1} of ${steps.length}: in the direction ${place3(step.direction)} it finds a vertex`;
  const nearest = step.nearest
    ? `; the simplex comes within ${digits(length3(step.nearest))} of the point`
    : " that does not reach the point";
  if (now < steps.length - 1) return `${begin}${nearest}.`;
  return `${begin}${nearest}. It stops: ${beliefWords(belief)}.`;
}

/** What the rival says. */
export function beliefWords(belief: Belief["belief"]): string {
  return { intersecting: "“inside”", disjoint: "“outside”", gave_up: "“I give up”" }[belief];
}
