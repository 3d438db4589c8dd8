/// The directions in which the selected strike pots what it pots, as a wedge at the aim, with the
/// chance.
import { effect } from '@preact/signals';
import type { Triple } from '../../protocol';
import { isJudgedNow, judgedStrike, watchJudging } from '../../solve/judging';
import { wish } from '../../solve/solve_state';
import { degrees, percent } from '../../solve/solution_text';
import type { Judged } from '../../protocol';
import { kDrawingPriority, type MakePart } from '../parts';
import { kColours, type Figure, type Line } from './figure';
import { shortAngle } from './rays';
import { forTests, sketchOf } from './sketch';
import { shownStrike, strikeView } from './strike';
import { contactOf, strikeHandles, type StrikeView } from './strike_figure';
import { polar } from './strike_geometry';

const kArc = 16; // pieces
const kNearest = 0.2; // m, of the arc from the ball

/// "one: 78 %, −0.41° to +0.80°".
export function windowText({ pots, window: [from, to], chance }: Judged, direction: number): string {
    const edge = (angle: number) => {
        const off = shortAngle(angle - direction);
        return `${off < 0 ? '−' : '+'}${degrees(Math.abs(off))}`;
    };
    return `${pots.map(({ ball }) => ball).join(', ')}: ${percent(chance)}, ${edge(from)} to ${edge(to)}`;
}

export function windowFigure(judged: Judged, view: StrikeView, isFresh: boolean): Figure {
    const [x, y, level] = view.centre;
    const [from, to] = judged.window;
    const reach = Math.max(contactOf(view).distance, kNearest);
    const at = (angle: number, distance: number): Triple =>
        [...polar([x, y], angle, distance), level];
    const colour = kColours.potted;
    const arc = Array.from({ length: kArc }, (_, i): Line => ({
        from: at(from + ((to - from) * i) / kArc, reach),
        to: at(from + ((to - from) * (i + 1)) / kArc, reach), colour,
    }));
    const sides = [from, to].map((angle): Line =>
        ({ from: at(angle, view.radius), to: at(angle, reach), colour, isFaint: true }));
    const handle = strikeHandles(view)[0]?.at ?? view.centre;
    return {
        lines: [...arc, ...sides],
        labels: isFresh ? [{ at: handle, text: windowText(judged, view.direction) }] : [],
    };
}

export const makeAimWindow: MakePart = (context) => {
    const sketch = sketchOf(context);
    forTests['judged'] = () => judgedStrike.peek();
    const ends = [
        watchJudging(),
        effect(() => {
            const judged = wish.value === null && shownStrike.value?.isChosen
                ? judgedStrike.value : null;
            const view = strikeView.value;
            sketch.show('aim-window', judged && view
                ? windowFigure(judged, view, isJudgedNow.value) : {});
        }),
    ];
    return {
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};
