/// Where the tip hits the ball, and the direction of the aim, as two discs to drag.
import type { Change } from '../edit/edit';
import { keyStep } from '../input/key_run';
import type { KeyPath, ShotEvent } from '../protocol';
import { valueAt } from '../view/gizmos/shot_values';
import { kMiscueOffset } from '../view/gizmos/strike_geometry';
import { dragOn, kArrows } from './disc_drag';
import { OutcomeStrip } from './OutcomeStrip';

const kRadius = 44; // px of the ball, and of the dial
const kStep = 0.01; // ball radii
const kDegree = Math.PI / 180;

function pointIn(disc: Element, event: PointerEvent): [number, number] {
    const box = disc.getBoundingClientRect();
    return [(event.clientX - box.left - box.width / 2) / kRadius,
        -(event.clientY - box.top - box.height / 2) / kRadius];
}

function tipChanges(path: KeyPath, x: number, y: number): Change[] {
    const length = Math.max(1, Math.hypot(x, y));
    return [{ path: [...path, 'strike', 'tip'], precision: kStep,
        value: [Math.round(x / length / kStep) * kStep, Math.round(y / length / kStep) * kStep] }];
}

function directionChanges(event: ShotEvent, angle: number): Change[] {
    return [{ path: [...event.path, 'strike', 'direction'], value: angle, precision: 0.1 * kDegree }];
}

/// Where the text puts the tip; the server's answer may be older.
function tipInText(event: ShotEvent): readonly [number, number] {
    const tip = valueAt([...event.path, 'strike', 'tip']);
    return Array.isArray(tip) && typeof tip[0] === 'number' && typeof tip[1] === 'number'
        ? [tip[0], tip[1]] : [event.tip[0], event.tip[1]];
}

/// The direction that the text gives, or, if it follows from an aim, the simulated one.
function directionInText(event: ShotEvent): number {
    const direction = valueAt([...event.path, 'strike', 'direction']);
    return typeof direction === 'number' ? direction : event.direction;
}

function TipDisc({ event }: { event: ShotEvent }) {
    const [x, y] = event.tip;
    const isMiscue = Math.hypot(x, y) > kMiscueOffset;
    const press = (key: KeyboardEvent) => {
        const arrow = kArrows[key.key];
        if (arrow) {
            const step = key.shiftKey ? 0.1 : kStep;
            key.preventDefault();
            keyStep<readonly [number, number]>({
                id: `${event.path.join('/')} tip`, label: 'Move tip', isOfScene: true,
                start: tipInText(event),
                next: ([right, up]) => [right + arrow[0] * step, up + arrow[1] * step],
                changes: ([right, up]) => tipChanges(event.path, right, up),
            });
        }
    };
    return (
        <figure>
            <svg viewBox="-50 -50 100 100" width="100" height="100" role="slider" tabindex={0}
                aria-label="Where the tip hits the ball" aria-valuenow={Math.hypot(x, y)}
                aria-valuemin={0} aria-valuemax={1}
                aria-valuetext={`${x.toFixed(2)} right, ${y.toFixed(2)} up, in ball radii${isMiscue ? ', miscue' : ''}`}
                onKeyDown={press}
                onPointerDown={(down) => dragOn(down, 'Move tip',
                    (disc, at) => tipChanges(event.path, ...pointIn(disc, at)))}>
                <circle class="ball" r={kRadius} />
                <path class="cross" d={`M${-kRadius} 0H${kRadius}M0 ${-kRadius}V${kRadius}`} />
                <circle class="limit" r={kRadius * kMiscueOffset} />
                <circle class={isMiscue ? 'tip miscue' : 'tip'} cx={x * kRadius} cy={-y * kRadius} r={6} />
            </svg>
            <figcaption>{isMiscue ? 'tip: miscue' : `tip ${x.toFixed(2)}, ${y.toFixed(2)}`}</figcaption>
        </figure>
    );
}

function Dial({ event }: { event: ShotEvent }) {
    const angle = event.direction;
    const degrees = angle / kDegree;
    const [x, y] = [Math.cos(angle) * (kRadius - 6), -Math.sin(angle) * (kRadius - 6)];
    const press = (key: KeyboardEvent) => {
        const turn = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[key.key];
        if (turn) {
            const step = key.shiftKey ? 5 : key.altKey ? 0.1 : 1;
            key.preventDefault();
            keyStep({
                id: `${event.path.join('/')} direction`, label: 'Turn the aim', isOfScene: true,
                start: directionInText(event), next: (from) => from + turn * step * kDegree,
                changes: (next) => directionChanges(event, next),
            });
        }
    };
    return (
        <figure>
            <svg viewBox="-50 -50 100 100" width="100" height="100" role="slider" tabindex={0}
                aria-label="Direction of the aim" aria-valuenow={Math.round(degrees * 10) / 10}
                aria-valuemin={-360} aria-valuemax={360} aria-valuetext={`${degrees.toFixed(1)} degrees`}
                onKeyDown={press}
                onPointerDown={(down) => dragOn(down, 'Turn the aim', (disc, at) => {
                    const [a, b] = pointIn(disc, at);
                    return directionChanges(event, Math.atan2(b, a));
                })}>
                <circle class="dial" r={kRadius} />
                {Array.from({ length: 24 }, (_, i) => (
                    <path key={i} class="cross" transform={`rotate(${15 * i})`}
                        d={`M${kRadius} 0H${kRadius - (i % 6 === 0 ? 9 : 4)}`} />
                ))}
                <path class="hand" d={`M0 0L${x} ${y}`} />
                <circle class="tip" cx={x} cy={y} r={5} />
            </svg>
            <figcaption>{event.toward ? `toward ${event.toward}` : `${degrees.toFixed(1)}°`}</figcaption>
        </figure>
    );
}

/// The discs of a strike.
export function StrikeTool({ event }: { event: ShotEvent }) {
    return (
        <>
            <div class="strike"><TipDisc event={event} /><Dial event={event} /></div>
            <OutcomeStrip event={event} />
        </>
    );
}
