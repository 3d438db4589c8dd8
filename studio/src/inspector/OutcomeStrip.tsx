/// What comes of the strike with other directions and speeds, as a picture: a click or a drag in it sets
/// both.
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Change } from '../edit/edit';
import { keyStep } from '../input/key_run';
import type { ShotEvent, StrikeMap } from '../protocol';
import { shownMap } from '../solve/judging';
import { pocketWords } from '../solve/solution_text';
import { theme } from '../state/state';
import { shortAngle, stepOf } from '../view/gizmos/rays';
import { kArrows, dragOn } from './disc_drag';

const kDegree = Math.PI / 180;

/// Tokens of the page's colours for the letters of the cells.
const kColours: Readonly<Record<string, string>> = {
    w: '--good', a: '--danger', n: '--active',
};

/// Paints the cells, the lowest speed at the bottom.
function paint(canvas: HTMLCanvasElement, { columns, rows, cells }: StrikeMap): void {
    const style = getComputedStyle(canvas);
    const pen = canvas.getContext('2d');
    canvas.width = columns;
    canvas.height = rows;
    for (let i = 0; pen && i < cells.length; ++i) {
        pen.fillStyle = style.getPropertyValue(kColours[cells[i] ?? 'n'] ?? '--active');
        pen.fillRect(i % columns, rows - 1 - Math.floor(i / columns), 1, 1);
    }
}

function strikeChanges(event: ShotEvent, map: StrikeMap, direction: number, speed: number): Change[] {
    const path = [...event.path, 'strike'];
    const [step, pace] = [(map.directions[1] - map.directions[0]) / 200,
        (map.speeds[1] - map.speeds[0]) / 100];
    return [
        { path: [...path, 'direction'], value: direction,
            precision: stepOf(step / kDegree, 1e-3, 0.1) * kDegree },
        { path: [...path, event.ball_speed ? 'ball_speed' : 'speed'], value: speed,
            precision: stepOf(pace, 1e-3, 0.1) },
    ];
}

function share(value: number, [from, to]: readonly [number, number]): number {
    return Math.min(Math.max((value - from) / (to - from), 0), 1);
}

/// The direction as it lies in the map, which may differ by whole turns.
function inMap(direction: number, { directions: [from, to] }: StrikeMap): number {
    const middle = (from + to) / 2;
    return middle + shortAngle(direction - middle);
}

function about({ pots }: StrikeMap): string {
    return pots.map(({ ball, pocket }) => `${ball} in ${pocket ? pocketWords(pocket) : 'a pocket'}`)
        .join(', ');
}

function Picture({ event, map }: { event: ShotEvent; map: StrikeMap }) {
    const canvas = useRef<HTMLCanvasElement>(null);
    const look = theme.value;
    useLayoutEffect(() => {
        if (canvas.current) {
            paint(canvas.current, map);
        }
    }, [map, look]);
    const direction = inMap(event.direction, map);
    const at = ([x, y]: readonly [number, number]) => strikeChanges(event, map,
        map.directions[0] + Math.min(Math.max(x, 0), 1) * (map.directions[1] - map.directions[0]),
        map.speeds[0] + Math.min(Math.max(y, 0), 1) * (map.speeds[1] - map.speeds[0]));
    const place = (strip: Element, pointer: PointerEvent): [number, number] => {
        const box = strip.getBoundingClientRect();
        return [(pointer.clientX - box.left) / box.width, 1 - (pointer.clientY - box.top) / box.height];
    };
    const press = (key: KeyboardEvent) => {
        const arrow = kArrows[key.key];
        if (arrow) {
            const by = key.shiftKey ? 5 : 1;
            key.preventDefault();
            keyStep<readonly [number, number]>({
                id: `${event.path.join('/')} map`, label: 'Change the strike', isOfScene: true,
                start: [share(direction, map.directions), share(event.speed, map.speeds)],
                next: ([x, y]) => [x + (arrow[0] * by) / map.columns, y + (arrow[1] * by) / map.rows],
                changes: at,
            });
        }
    };
    return (
        <div class="strip-map" role="slider" tabindex={0}
            aria-label="Direction and speed, and what comes of them"
            aria-valuenow={Math.round(event.speed * 100) / 100} aria-valuemin={map.speeds[0]}
            aria-valuemax={map.speeds[1]}
            aria-valuetext={`${(direction / kDegree).toFixed(2)} degrees, ${event.speed.toFixed(2)} m/s`}
            onKeyDown={press}
            onPointerDown={(down) => dragOn(down, 'Change the strike',
                (strip, pointer) => at(place(strip, pointer)))}>
            <canvas ref={canvas} aria-hidden="true" />
            <i style={{ left: `${100 * share(direction, map.directions)}%`,
                bottom: `${100 * share(event.speed, map.speeds)}%` }} />
        </div>
    );
}

/// The map of a strike, once it is known.
export function OutcomeStrip({ event }: { event: ShotEvent }) {
    const map = shownMap.value;
    if (!map) {
        return null;
    }
    const [from, to] = map.directions.map((angle) => `${(angle / kDegree).toFixed(1)}°`);
    const [slow, fast] = map.speeds.map((speed) => `${Number(speed.toFixed(1))}`);
    return (
        <figure class="outcome-strip">
            <figcaption>
                <span class="w">{about(map)}</span>
                {map.cells.includes('a') ? <span class="a">{event.object} in a pocket</span> : null}
            </figcaption>
            <div class="speeds" aria-hidden="true"><span>{fast} m/s</span><span>{slow}</span></div>
            <Picture event={event} map={map} />
            <div class="directions" aria-hidden="true"><span>{from}</span><span>{to}</span></div>
        </figure>
    );
}
