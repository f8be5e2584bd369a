/** The view of two moving bodies, with the bar of certified intervals and the plane that separates them now. */

import type { Control, Figure } from "../../kit/chapter";
import { button, html } from "../../kit/elements";
import { bodyAt, placeAt, turned } from "../../kit/placement";
import { drawPlane } from "../../kit/separating_plane";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { TimeBar, type Span } from "../../kit/time_bar";
import { add3, cross3, digits, dot3, length3, place3, scale3, sub3, tidy3 } from "../../kit/vectors";
import { mixed, zoneColour } from "../../kit/zone_colours";
import type { Faces } from "../../library/pictures";
import type { Interval, Motion } from "../../library/space";
import type { Body, Vec3 } from "../../library/shapes";
import type { Answers, Scene, State } from "./state";

/** Seconds that the whole step takes when it plays. */
const DURATION = 5;

/** Half of the side of the separating square. */
const PLANE_SIZE = 1.6;

const LOOKS: Readonly<Record<Interval["frame"], string>> = { space: "", a: "other", b: "other", edges: "third" };

export function motionFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView(
    "Two moving bodies",
    {
      moved: (id, place, finished) => {
        const { state } = control;
        const { scene } = state;
        // The body is pulled as it stands now; its axis goes with it.
        const key = id === "a" ? "a" : "b";
        const shift = sub3(place, placeAt(scene[key].center, scene.moves[key], state.time));
        const body = { ...scene[key], center: tidy3(add3(scene[key].center, shift)) };
        const move = { ...scene.moves[key], axis_point: tidy3(add3(scene.moves[key].axis_point, shift)) };
        const next = { ...state, scene: { ...scene, [key]: body, moves: { ...scene.moves, [key]: move } } };
        (finished ? control.commit : control.change)(next);
      },
    },
    [1.2, -2.2, 3.2],
  );
  const [first, second, plane] = [new Solid(), new Solid(), new Solid()];
  view.put("plane", plane);
  view.put("a", first);
  view.put("b", second);
  const bar = new TimeBar((time, finished) => {
    stop();
    (finished ? control.commit : control.change)({ ...control.state, time });
  });
  const told = html("p", { class: "told" });
  let shown: {
    readonly scene: Scene;
    readonly collision: Answers["collision"];
    readonly spans: readonly Span[];
  } | null = null;
  let playing = 0;
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const tenth = () =>
    control.commit({ ...control.state, time: control.state.time >= 1 ? 0 : Math.min(1, control.state.time + 0.1) });
  const play = calm
    ? button("One tenth on", tenth, { "data-tool": "play" })
    : button("Play", () => (playing ? stop() : start()), { "data-tool": "play" });
  const stop = () => {
    if (!playing) return;
    cancelAnimationFrame(playing);
    playing = 0;
    play.textContent = "Play";
  };
  const start = () => {
    const from = control.state.time >= 1 ? 0 : control.state.time;
    const begin = performance.now();
    play.textContent = "Pause";
    const step = (now: number) => {
      if (!play.isConnected) return stop();
      const time = Math.min(1, from + (now - begin) / 1000 / DURATION);
      control.change({ ...control.state, time });
      if (time < 1) playing = requestAnimationFrame(step);
      else stop();
    };
    playing = requestAnimationFrame(step);
  };
  return {
    element: html("div", {}, view.element, bar.element, html("div", { class: "tools" }, play), told),
    svg: () => view.svg(),
    draw(state, answers) {
      const { scene, time } = state;
      const [a, b] = [bodyAt(scene.a, scene.moves.a, time), bodyAt(scene.b, scene.moves.b, time)];
      drawPlaced(first, answers.a, scene.moves.a, time, "#0072b2");
      drawPlaced(second, answers.b, scene.moves.b, time, "#e69f00");
      // While the motion plays only the time changes: what belongs to the whole step stays.
      if (shown?.scene !== scene || shown.collision !== answers.collision) {
        shown = { scene, collision: answers.collision, spans: spans(answers) };
        view.fit([...way(scene.a, scene.moves.a, answers.a), ...way(scene.b, scene.moves.b, answers.b)]);
      }
      const { intervals } = answers.collision.result.certificate;
      const interval = intervals.find((one) => one.from <= time && time <= one.to) ?? null;
      const u = interval && directionAt(interval, scene.moves, time);
      drawGap(plane, u, a, b);
      bar.draw(time, shown.spans);
      told.textContent = sentence(state, answers, interval, u, a, b);
      view.draw([
        { id: "a", at: a.center, label: `The first body, at ${place3(a.center)}`, look: "query", name: "A" },
        { id: "b", at: b.center, label: `The second body, at ${place3(b.center)}`, look: "query", name: "B" },
      ]);
    },
  };
}

function spans({ collision }: Answers): Span[] {
  const { status, time, certificate } = collision.result;
  const proved = certificate.intervals.map(
    (one): Span => ({
      from: one.from,
      to: one.to,
      look: LOOKS[one.frame],
      title: `apart from ${digits(one.from)} to ${digits(one.to)}: one direction, ${frameName(one.frame)}`,
    }),
  );
  if (!time || status === "separate") return proved;
  return [...proved, { from: time[1], to: 1, look: "contact", title: `first contact at ${digits(time[1], 8)}` }];
}

function frameName(frame: Interval["frame"]): string {
  return {
    space: "fixed in space",
    a: "turning with the first body",
    b: "turning with the second body",
    edges: "at right angles to an edge of each",
  }[frame];
}

/** The direction of an interval as it stands at a time. */
function directionAt(interval: Interval, moves: { a: Motion; b: Motion }, time: number): Vec3 {
  const { frame, direction } = interval;
  const by = (motion: Motion, v: Vec3) => turned(v, motion.axis, motion.angle * time);
  if (frame === "edges") {
    const [e, f] = direction as readonly [Vec3, Vec3];
    return cross3(by(moves.a, e), by(moves.b, f));
  }
  const u = direction as Vec3;
  return frame === "a" ? by(moves.a, u) : frame === "b" ? by(moves.b, u) : u;
}

function sentence(state: State, answers: Answers, interval: Interval | null, u: Vec3 | null, a: Body, b: Body): string {
  const { time } = state;
  if (interval && u) {
    const size = length3(u) || 1;
    const gap = (dot3(u, sub3(b.center, a.center)) - reachIn(u, a) - reachIn(u, b)) / size;
    return (
      `At time ${digits(time)} a plane separates the bodies; the gap between them is at least ` +
      `${digits(gap)}. The direction is ${frameName(interval.frame)} and good from ` +
      `${digits(interval.from)} to ${digits(interval.to)}.`
    );
  }
  const contact = answers.collision.result.time;
  return contact && time >= contact[0]
    ? `At time ${digits(time)} the first contact, at ${digits(contact[1], 8)}, is past.`
    : `Time ${digits(time)}.`;
}

function reachIn(u: Vec3, body: Body): number {
  return body.generators.reduce((sum, generator) => sum + Math.abs(dot3(u, generator)), 0);
}

/** Places that a body comes to: at three times, a box around it whichever way it is turned. */
function way(body: Body, motion: Motion, faces: Faces): Vec3[] {
  const size = Math.max(0, ...faces.vertices.map((vertex) => length3(sub3(vertex, body.center))));
  return [0, 0.5, 1].flatMap((time) => {
    const center = placeAt(body.center, motion, time);
    return (
      [
        [size, 0, 0],
        [-size, 0, 0],
        [0, size, 0],
        [0, -size, 0],
      ] as const
    ).map((shift) => add3(center, shift));
  });
}

export function drawPlaced(
  solid: Solid,
  faces: Faces,
  motion: Motion,
  time: number,
  colour: string,
  opacity = 1,
): void {
  solid.drawFrom(faces, () => [
    solidOf(faces),
    {
      facets: faces.facet_zones.map((zones) => mixed([colour, colour, ...zones.map(zoneColour)])),
      opacity,
      edge: "#20242a",
    },
  ]);
  solid.place((point) => placeAt(point, motion, time));
}

/** The plane in the middle of the gap between two bodies. */
function drawGap(plane: Solid, direction: Vec3 | null, a: Body, b: Body): void {
  const size = direction ? length3(direction) : 0;
  if (!direction || size === 0) return plane.clear();
  const u = scale3(direction, 1 / size);
  const [end, begin] = [dot3(u, a.center) + reachIn(u, a), dot3(u, b.center) - reachIn(u, b)];
  const between = scale3(add3(a.center, b.center), 0.5);
  drawPlane(plane, add3(between, scale3(u, (end + begin) / 2 - dot3(u, between))), u, PLANE_SIZE);
}
