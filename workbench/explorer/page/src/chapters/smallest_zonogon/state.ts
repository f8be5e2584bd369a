/** The state of the chapter, and the questions that it asks. */

import type { Answer, Verdict } from "../../engine/questions";
import type { Asking, AskingLater } from "../../kit/chapter";
import { finite, fields, list, vec2, within } from "../../kit/reading";
import { add2, length2, scale2, sub2 } from "../../kit/vectors";
import {
  areaAlong,
  areaSearch,
  centeredZonogon,
  levelSets,
  pruning,
  zonogon,
  type AreaSearch,
  type CenteredZonogon,
  type Pruning,
} from "../../library/pictures";
import { leastArea, type LeastArea } from "../../library/plane";
import type { Vec2 } from "../../library/shapes";

export interface State {
  readonly points: readonly Vec2[];
  /** The centre O. */
  readonly center: Vec2;
  /** The direction of the line through O, in degrees. */
  readonly turn: number;
  /** The step of the search that is seen. */
  readonly step: number;
  /** Whether the level sets of f are drawn. */
  readonly levels: boolean;
}

export interface Late {
  readonly of: readonly Vec2[];
  readonly verdict: Verdict;
  readonly search: AreaSearch | null;
  readonly pruning: Pruning | null;
  readonly levels: readonly (readonly Vec2[])[];
}

export interface Answers {
  readonly zonogon: CenteredZonogon;
  readonly best: Answer<LeastArea>;
  /** The vertices of the zonogon of least area. */
  readonly outline: readonly Vec2[];
  /** The line through O: its ends, and f on it. */
  readonly line: {
    readonly from: Vec2;
    readonly to: Vec2;
    readonly at: readonly number[];
    readonly area: readonly number[];
  };
  readonly late: Late | null;
}

/** Points up to which the steps of the search are asked for. */
const SEARCH_LIMIT = 200;

/** Lines up to which pruning stops and walks along lines instead. */
const PRUNED = 12;

/** Levels of f above its least value, as parts of it. */
const LEVELS = [1.05, 1.15, 1.3, 1.5, 1.75, 2.1, 2.5, 3];

export const first = (): State => ({
  points: [
    [5.5, 2.5],
    [4, 3.1],
    [1.6, 3.3],
    [0.3, 2.8],
    [0.7, 1.5],
    [1.8, 0.1],
    [3, 0.2],
    [4.9, 1.3],
    [2.4, 1.7],
  ],
  center: [3.6, 2.3],
  turn: 20,
  step: 0,
  levels: false,
});

export function read(told: unknown): State | null {
  const object = fields(told);
  const points = list(object?.["points"], vec2, 5000);
  const center = vec2(object?.["center"]);
  if (!points || points.length === 0 || !center) return null;
  return {
    points,
    center,
    turn: within(object?.["turn"], -360, 360) ?? 0,
    step: Math.max(0, Math.round(finite(object?.["step"]) ?? 0)),
    levels: object?.["levels"] === true,
  };
}

/** The reach of the picture: how far the points are from O, at most. */
export function reach(state: State): number {
  return Math.max(...state.points.map((point) => length2(sub2(point, state.center)))) || 1;
}

export function direction(turn: number): Vec2 {
  const angle = (turn * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

export function questions(state: State, asking: Asking, late: Late | null): Answers {
  const half = scale2(direction(state.turn), reach(state));
  const [from, to] = [sub2(state.center, half), add2(state.center, half)];
  const best = asking.ask(leastArea(state.points));
  return {
    zonogon: asking.ask(centeredZonogon(state.points, state.center)).result,
    best,
    outline: asking.ask(zonogon(best.result.center, best.result.generators)).result.vertices,
    line: { from, to, ...asking.ask(areaAlong(state.points, from, to)).result },
    late: late?.of === state.points ? late : null,
  };
}

export async function later(state: State, asking: AskingLater): Promise<Late> {
  const best = await asking.askLater(leastArea(state.points));
  const least = Number(best.result.area);
  const hull = best.result.certificate.hull.length;
  const [verdict, search, pruned, levels] = await Promise.all([
    asking.verifyLater(best),
    hull <= SEARCH_LIMIT && hull > 2 ? asking.askLater(areaSearch(state.points)) : null,
    hull > 2 ? asking.askLater(pruning(state.points, PRUNED)) : null,
    state.levels && hull <= SEARCH_LIMIT && least > 0
      ? asking.askLater(
          levelSets(
            state.points,
            LEVELS.map((part) => part * least),
          ),
        )
      : null,
  ]);
  return {
    of: state.points,
    verdict,
    search: search?.result ?? null,
    pruning: pruned?.result ?? null,
    levels: levels?.result.polygons ?? [],
  };
}

/** The names of points: P with the number, from 1. */
export function pointName(index: number): string {
  return `P${String(index + 1).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[Number(digit)] ?? digit)}`;
}
