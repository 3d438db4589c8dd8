/// Strikes that pot a ball, as the paths of what they move: all faintly, the chosen one with its ghost
/// balls. The wheel and the arrow keys go through them, a click or Enter writes one, and the ring where
/// the struck ball shall end is dragged.
import { effect } from '@preact/signals';
import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from 'three';
import { kSolutionsNumbersPerPoint, type SceneObject, type Triple } from '../../protocol';
import {
    choose, leaveSearch, step, watchSearch, wishRest, writeChosen,
} from '../../solve/search';
import {
    chosenIndex, found, isPlacing, kWithin, pocketAt, restPlace, shownSolutions, wish,
} from '../../solve/solve_state';
import { isChanceKnown, percent } from '../../solve/solution_text';
import { shot, type Solutions } from '../../state/state';
import { kHandlePriority, type Drag, type MakePart, type Pixel, type ViewContext } from '../parts';
import { trailColour } from '../trail_lines';
import { follower, pixelDistance, reachOf } from './dragging';
import { fanLines } from './fan';
import { kColours, type Figure, type Line } from './figure';
import { inWorld, takesArrows } from './nudge';
import { forTests, sketchOf } from './sketch';

const kPriority = kHandlePriority + 10; // the ring and the paths lie over all handles
const kClick = 4; // CSS pixels; a longer way is a drag
const kNotch = 40; // of a wheel: one solution
const kStep = 0.05; // m, of the place by an arrow key
const kCircle = 48; // pieces

/// The polylines of one solution.
export function pathsOf({ head, numbers }: Solutions, index: number) {
    return head.tracks.filter(({ run }) => run === index).map(({ name, first, points }) => ({
        name,
        points: Array.from({ length: points }, (_, i): Triple => {
            const at = first + i * kSolutionsNumbersPerPoint;
            return [numbers[at + 1] ?? 0, numbers[at + 2] ?? 0, numbers[at + 3] ?? 0];
        }),
    }));
}

function circle([x, y]: readonly [number, number], radius: number, colour: number): Line[] {
    const at = (i: number): Triple => [x + radius * Math.cos((2 * Math.PI * i) / kCircle),
        y + radius * Math.sin((2 * Math.PI * i) / kCircle), 0.002];
    return Array.from({ length: kCircle }, (_, i) =>
        ({ from: at(i), to: at(i + 1), colour, isFaint: true }));
}

/// The chosen solution: strong paths, where the balls end, its chance at the pocket.
function chosenFigure(all: Solutions, index: number, balls: readonly SceneObject[]): Figure {
    const solution = all.head.solutions[index];
    const pocket = shot.value?.pockets.find(({ name }) => name === solution?.pocket);
    const lines: Line[] = [];
    const ghosts: Figure['balls'] = [];
    for (const { name, points } of pathsOf(all, index)) {
        const ball = balls.find((one) => one.name === name);
        const colour = ball ? trailColour(ball).getHex() : kColours.aim;
        for (let i = 0; i + 1 < points.length; ++i) {
            lines.push({ from: points[i] as Triple, to: points[i + 1] as Triple, colour });
        }
        const end = points.at(-1);
        if (ball?.kind === 'ball' && end && end[2] > 0) {
            ghosts.push({ at: end, radius: ball.radius, colour });
        }
    }
    return {
        lines, balls: ghosts,
        labels: solution && pocket ? [{
            at: [...pocket.place, 0.03],
            text: `${index + 1} of ${all.head.solutions.length}`
                + (isChanceKnown(solution) ? `: ${percent(solution.chance)}` : ''),
        }] : [],
    };
}

/// The ring where the struck ball ends, and how near it has to come once a place is wished.
function restFigure(isHot: boolean): Figure {
    const place = restPlace.value;
    const one = wish.value;
    if (!one || !place) {
        return {};
    }
    const colour = one.rest ? kColours.accent : kColours.aim;
    return {
        lines: one.rest ? circle(one.rest, kWithin, kColours.accent) : [],
        dots: [{ at: [...place, 0.03], colour, size: isHot ? 24 : 20, shape: 'ring' }],
        labels: isHot || one.rest ? [{
            at: [...place, 0.03], isBelow: true,
            text: one.rest ? `${one.struck} ends here` : `drag: where ${one.struck} ends`,
        }] : [],
    };
}

function distanceTo([x, y]: [number, number], a: [number, number], b: [number, number]): number {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(Math.max(((x - a[0]) * dx + (y - a[1]) * dy) / square, 0), 1) : 0;
    return Math.hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

/// The solution whose path is at a pixel, the chosen one before others; -1 without any.
function solutionAt(context: ViewContext, pixel: Pixel): number {
    const all = shownSolutions.peek();
    if (!all || context.objectAt(pixel)?.kind === 'ball') {
        return -1;
    }
    const box = context.canvas.getBoundingClientRect();
    const here: [number, number] = [pixel.clientX - box.left, pixel.clientY - box.top];
    let best = -1;
    let least = reachOf(pixel) * 0.7;
    all.head.solutions.forEach((_, index) => {
        const bonus = index === chosenIndex.peek() ? 2 : 0;
        for (const { points } of pathsOf(all, index)) {
            const seen = points.map((point) => context.toScreen(point));
            for (let i = 0; i + 1 < seen.length; ++i) {
                const [a, b] = [seen[i], seen[i + 1]];
                const distance = a && b ? distanceTo(here, a, b) - bonus : Infinity;
                if (distance < least) {
                    [best, least] = [index, distance];
                }
            }
        }
    });
    return best;
}

function isAtRing(context: ViewContext, pixel: Pixel): boolean {
    const place = restPlace.peek();
    return wish.peek() !== null && place !== null
        && pixelDistance(context, [...place, 0.03], pixel) <= reachOf(pixel) + 3;
}

/// Drags the ring: over a pocket it is where it was, because no ball rests there.
function dragRing(context: ViewContext, start: PointerEvent, place: [number, number]): Drag {
    const before = wish.peek()?.rest ?? null;
    const follow = follower(context, [...place, 0.03], start);
    return {
        move: (event) => {
            isPlacing.value = true;
            const to = follow(event, 'level');
            const state = shot.peek();
            if (to && state?.table && !pocketAt(to, state.pockets)) {
                const radius = state.table.ball_radius;
                const inside = (at: number, length: number) =>
                    Math.min(Math.max(at, radius - length / 2), length / 2 - radius);
                wishRest([inside(to[0], state.table.length), inside(to[1], state.table.width)]);
            }
        },
        end: () => { isPlacing.value = false; },
        cancel: () => {
            isPlacing.value = false;
            wishRest(before);
        },
    };
}

/// A click on a path chooses its solution; on that of the chosen one it writes the strike.
function clickPath(start: PointerEvent, index: number): Drag {
    return {
        move: () => {},
        end: (event) => {
            const way = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
            if (way < kClick && index === chosenIndex.peek()) {
                writeChosen();
            } else if (way < kClick) {
                choose(index);
            }
        },
        cancel: () => {},
    };
}

/// Keys and wheel while something is sought, before all others that use them.
function answerKeys(context: ViewContext): () => void {
    const onKey = (event: KeyboardEvent) => {
        const isOurs = wish.peek() !== null && !event.ctrlKey && !event.metaKey && !event.altKey
            && !takesArrows(event.target) && document.querySelector('dialog:modal') === null;
        if (!isOurs) {
            return;
        }
        const ways: Readonly<Record<string, [number, number]>> = {
            ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
        };
        const way = ways[event.key];
        const place = restPlace.peek();
        const isOnButton = event.target instanceof Element && event.target.closest('button') !== null;
        if (way && event.shiftKey && place) {
            const [x, y] = inWorld(context, way);
            wishRest([place[0] + kStep * x, place[1] + kStep * y]);
        } else if (way) {
            step(way[0] > 0 || way[1] < 0 ? 1 : -1);
        } else if (event.key === 'Enter' && !isOnButton) {
            writeChosen();
        } else if (event.key === 'Escape' && !isPlacing.peek()) {
            leaveSearch();
        } else {
            return;
        }
        event.preventDefault();
        event.stopImmediatePropagation();
    };
    let turned = 0;
    const onWheel = (event: WheelEvent) => {
        if (wish.peek() === null || found.peek().length < 2 || event.ctrlKey || event.metaKey) {
            return;
        }
        event.preventDefault();
        event.stopImmediatePropagation();
        turned += event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY : 3 * kNotch * event.deltaY;
        if (Math.abs(turned) >= kNotch) {
            step(Math.sign(turned));
            turned = 0;
        }
    };
    window.addEventListener('keydown', onKey, { capture: true });
    context.canvas.addEventListener('wheel', onWheel, { capture: true, passive: false });
    return () => {
        window.removeEventListener('keydown', onKey, { capture: true });
        context.canvas.removeEventListener('wheel', onWheel, { capture: true });
    };
}

export const makeSolutions: MakePart = (context) => {
    const sketch = sketchOf(context);
    const others = new LineSegments(new BufferGeometry(), new LineBasicMaterial({
        vertexColors: true, transparent: true, opacity: 0.3, depthWrite: false,
    }));
    others.frustumCulled = false;
    context.scene.add(others);
    forTests['solutionPieces'] = () => (others.visible
        ? (others.geometry.getAttribute('position')?.count ?? 0) / 2 : 0);
    let isHot = false;
    const showRest = () => sketch.show('solution-rest', restFigure(isHot));
    const ends = [
        watchSearch(),
        answerKeys(context),
        effect(() => {
            const all = shownSolutions.value;
            const index = chosenIndex.value;
            const balls = shot.value?.objects ?? [];
            sketch.show('solutions', all && index >= 0 ? chosenFigure(all, index, balls) : {});
            const faint = all
                ? { ...all.head, tracks: all.head.tracks.filter(({ run }) => run !== index) } : null;
            others.visible = faint !== null && faint.tracks.length > 0;
            if (faint && all) {
                const { places, colours } = fanLines(faint, all.numbers, balls);
                others.geometry.dispose();
                others.geometry = new BufferGeometry()
                    .setAttribute('position', new Float32BufferAttribute(places, 3))
                    .setAttribute('color', new Float32BufferAttribute(colours, 3));
            }
            context.ask();
        }),
        effect(() => {
            void [wish.value, restPlace.value];
            showRest();
        }),
    ];
    return {
        priority: kPriority,
        grab: (event) => {
            const place = restPlace.peek();
            if (place && isAtRing(context, event)) {
                return dragRing(context, event, place);
            }
            const index = solutionAt(context, event);
            if (index < 0) {
                return null;
            }
            return clickPath(event, index);
        },
        hover: (event) => {
            const wasHot = isHot;
            isHot = isAtRing(context, event);
            if (isHot !== wasHot) {
                showRest();
            }
            if (isHot) {
                return 'grab';
            }
            return solutionAt(context, event) >= 0 ? 'pointer' : null;
        },
        dispose: () => {
            ends.forEach((end) => end());
            others.removeFromParent();
            others.geometry.dispose();
            others.material.dispose();
            sketch.dispose();
        },
    };
};

