/** The figure of the hierarchy: two bodies with the bodies around them that were looked at last. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { Stepper } from "../../kit/stepper";
import { add3, scale3 } from "../../kit/vectors";
import type { Faces } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { STEPS, WAY, type MeetingOfTwo } from "./meeting";
import type { Answers, State } from "./state";

const LOOKS = [
  { colour: "#0072b2", opacity: 1 },
  { colour: "#e69f00", opacity: 1 },
  { colour: "#56b4e9", opacity: 0.22 },
  { colour: "#f0e442", opacity: 0.22 },
] as const;

export function hierarchyFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("Two bodies with the bodies around them", {}, [1, -6, 3]);
  const solids = LOOKS.map((_, index) => {
    const solid = new Solid();
    view.put(String(index), solid);
    return solid;
  });
  const stepper = new Stepper("The second body on its way", (at) => control.commit({ ...control.state, at }));
  let shown: MeetingOfTwo | null = null;
  return {
    element: html("div", {}, view.element, stepper.element),
    svg: () => view.svg(),
    draw({ at }, { meeting }) {
      if (shown === meeting) return;
      shown = meeting;
      const center = WAY[at] as Vec3;
      [...meeting.bodies, ...meeting.around].forEach((faces, index) => {
        show(solids[index] as Solid, faces, LOOKS[index] as (typeof LOOKS)[number]);
        if (index % 2 === 1) solids[index]?.place((point) => add3(point, center));
      });
      // At the ends of the way a coarse body reaches farther than its centre.
      view.fit([...meeting.bodies[0].vertices, ...WAY.map((place) => scale3(place, 1.15))]);
      view.draw([], [], [{ points: WAY, look: "thin" }]);
      stepper.draw(at, STEPS + 1, told(meeting));
    },
  };
}

function show(solid: Solid, faces: Faces, { colour, opacity }: { colour: string; opacity: number }): void {
  solid.drawFrom(faces, () => [solidOf(faces), { facets: faces.facets.map(() => colour), opacity, edge: colour }]);
}

function told({ found }: MeetingOfTwo): string {
  const [one, other] = found.levels.map((level, index) => (index === 0 ? found.a : found.b)[level]?.generators.length);
  const pairs = found.visited === 1 ? "one pair" : `${found.visited} pairs`;
  const after = `after ${pairs} of levels`;
  const { levels, a, b, status } = found;
  if (levels[0] === a.length - 1 && levels[1] === b.length - 1) {
    const words = { inside: "They overlap", boundary: "They touch", outside: "They are apart" }[status];
    return `${words}: only the bodies themselves, of ${one} and ${other} generators, tell, ${after}.`;
  }
  return status === "outside"
    ? `They are apart: bodies of ${one} and ${other} generators around them tell, ${after}.`
    : `They overlap: bodies within them, of the level of ${one} and ${other} generators, tell, ${after}.`;
}
