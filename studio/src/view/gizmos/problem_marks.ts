/// Shows errors of balls and objects where these are: a red ghost and the sentence.
import { effect } from '@preact/signals';
import type { KeyPath, Problem, SceneObject, Triple } from '../../protocol';
import { problems, shot } from '../../state/state';
import { bufferOf } from '../../text/buffers';
import { pathAt } from '../../text/follow_selection';
import { offsetsOf } from '../../text/problem_marks';
import { kDrawingPriority, type MakePart } from '../parts';
import { kColours, type Figure, type Line } from './figure';
import { valueAt } from './shot_values';
import { sketchOf } from './sketch';

const kDefaultRadius = 0.028575; // m, of a ball that was never valid
const kCirclePieces = 32;
const kLongest = 90; // characters

export const makeProblemMarks: MakePart = (context) => {
    const sketch = sketchOf(context);
    const end = effect(() => {
        const errors = (problems.value?.list ?? []).filter(({ severity }) => severity === 'error');
        sketch.show('problems', problemFigure(errors, shot.peek()?.objects ?? []));
    });
    return {
        priority: kDrawingPriority,
        dispose: () => {
            end();
            sketch.dispose();
        },
    };
};

/// The ball or object at whose place in the text a problem is.
function subjectOf(problem: Problem): KeyPath | null {
    const buffer = bufferOf(problem.place.file);
    const range = buffer && offsetsOf(buffer.state.doc, problem.place);
    const path = range ? pathAt(buffer.state.doc.toString(), range.from, 2) : [];
    return path.length === 2 && (path[0] === 'balls' || path[0] === 'objects') ? path : null;
}

/// Where the text puts it, else where it was when the text was last valid.
function placeOf(path: KeyPath, known: SceneObject | undefined): Triple | null {
    const at = valueAt([...path, 'at']);
    if (Array.isArray(at) && at.length >= 2 && at.every((one) => typeof one === 'number')) {
        const [x = 0, y = 0, z = known?.radius || kDefaultRadius] = at as number[];
        return [x, y, z];
    }
    return known ? known.position : null;
}

/// A level circle around a place.
function circle(at: Triple, radius: number): Line[] {
    const points = Array.from({ length: kCirclePieces + 1 }, (_, i): Triple => {
        const angle = (2 * Math.PI * i) / kCirclePieces;
        return [at[0] + radius * Math.cos(angle), at[1] + radius * Math.sin(angle), at[2]];
    });
    return points.slice(1).map((to, i) => ({ from: points[i] ?? to, to, colour: kColours.wrong }));
}

function problemFigure(errors: readonly Problem[], objects: readonly SceneObject[]): Figure {
    const marked = new Map<string, { at: Triple; radius: number; text: string }>();
    const find = ([section, name]: KeyPath) => objects.find((one) =>
        one.path[0] === section && one.path[1] === name);
    for (const problem of errors) {
        const path = subjectOf(problem);
        const known = path ? find(path) : undefined;
        const at = path && placeOf(path, known);
        if (path && at && !marked.has(path.join('/'))) {
            const { message } = problem;
            const text = message.length > kLongest ? `${message.slice(0, kLongest)}…` : message;
            marked.set(path.join('/'), { at, radius: known?.radius || kDefaultRadius, text });
        }
    }
    const wrong = [...marked.values()];
    if (wrong.length === 0) {
        return {};
    }
    // The other ball of a pair that overlaps.
    const others = objects.filter((one) => one.kind === 'ball' && !marked.has(one.path.join('/')))
        .map((one) => ({ at: placeOf(one.path, one) ?? one.position, radius: one.radius }))
        .filter((one) => wrong.some(({ at, radius }) =>
            Math.hypot(at[0] - one.at[0], at[1] - one.at[1], at[2] - one.at[2])
                < radius + one.radius - 1e-9));
    return {
        lines: wrong.flatMap(({ at, radius }) => circle(at, 1.35 * radius)),
        balls: [...wrong, ...others].map(({ at, radius }) =>
            ({ at, radius: radius * 1.04, colour: kColours.wrong })),
        labels: wrong.map(({ at, text }) => ({ at, text, tone: 'wrong' })),
    };
}
