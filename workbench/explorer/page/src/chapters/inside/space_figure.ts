/** The view of the bodies, the point, and what proves where it is: a plane between them, or a walk to the point. */

import type { Control, Figure } from "../../kit/chapter";
import { Solid } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { add3, cross3, dot3, length3, place3, scale3, tidy3 } from "../../kit/vectors";
import { mixed, zoneColour } from "../../kit/zone_colours";
import type { Faces } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { coefficients, direction, reachIn } from "./proof";
import { walk, type Answers, type State } from "./state";

/** The opacity of a body, so that the walk inside it is seen. */
const OPACITY = 0.45;

export function insideSpaceFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("The bodies and the point", {
    moved: (_, place, finished) => (finished ? control.commit : control.change)({ ...control.state, point: tidy3(place) }),
  });
  const [body, other, plane] = [new Solid(), new Solid(), new Solid()];
  view.put("plane", plane);
  view.put("body", body);
  view.put("other", other);
  return {
    element: view.element,
    svg: () => view.svg(),
    draw(state, answers) {
      draw(body, answers.body, "#0072b2");
      draw(other, answers.other, "#e69f00");
      const places: Vec3[] = [[0, 0, 0], state.point, ...(answers.body?.vertices ?? []), ...(answers.other?.vertices ?? [])];
      view.fit(places);
      const reach = Math.max(...places.map(length3));
      const u = direction(answers);
      drawPlane(plane, state, u, reach);
      const path = coefficients(answers);
      const drawn = path && path.length <= 60 ? [{ points: walk(state, path), look: "best" }] : [];
      const arrow = u ? [{ points: [scale3(u, reachIn(state, u)), state.point], look: "thin" }] : [];
      const name = state.others.length > 0 ? "c" : "p";
      view.draw(
        [{ id: "point", at: state.point, label: `${state.others.length > 0 ? "The centre of the second body" : "The point"} at ${place3(state.point)}; it moves in the plane of the screen`, look: "query", name }],
        [{ at: [0, 0, 0], text: "·" }],
        [...drawn, ...(answers.body ? [] : arrow)],
      );
    },
  };
}

function draw(solid: Solid, faces: Faces | null, colour: string): void {
  if (!faces) {
    solid.draw({ vertices: [], facets: [], edges: [] }, { facets: [], opacity: 1, edge: "#000000" });
    return;
  }
  const colours = faces.facet_zones.map((zones) => mixed([colour, colour, ...zones.map(zoneColour)]));
  const shape = { vertices: faces.vertices, facets: faces.facets, edges: faces.edges.map((edge) => edge.ends) };
  solid.draw(shape, { facets: colours, opacity: OPACITY, edge: colour });
}

/** A square in the middle of the gap, at right angles to the direction. */
function drawPlane(plane: Solid, state: State, u: Vec3 | null, reach: number): void {
  if (!u) return draw(plane, null, "#000000");
  // Of two bodies the gap is between the first one and the second one where that stands.
  const own = state.generators.reduce((sum, generator) => sum + Math.abs(dot3(u, generator)), 0);
  const theirs = dot3(u, state.point) - state.others.reduce((sum, generator) => sum + Math.abs(dot3(u, generator)), 0);
  const middle = scale3(u, (own + theirs) / 2);
  const across = unit(cross3(u, Math.abs(u[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  const upwards = cross3(u, across);
  const half = 0.75 * reach;
  const corner = (s: number, t: number) => add3(middle, add3(scale3(across, s * half), scale3(upwards, t * half)));
  const vertices = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  plane.draw({ vertices, facets: [[0, 1, 2, 3]], edges: [[0, 1], [1, 2], [2, 3], [3, 0]] }, { facets: ["#d55e00"], opacity: 0.25, edge: "#d55e00" });
}

function unit(v: Vec3): Vec3 {
  return scale3(v, 1 / (length3(v) || 1));
}
