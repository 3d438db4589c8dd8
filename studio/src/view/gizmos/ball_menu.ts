/// What the menu of a ball offers: to be struck or aimed at, to touch another ball, and to go back
/// to its place in the rack.
import { applyChanges, insertItem, removeValue, type Change } from '../../edit/edit';
import type { SceneObject } from '../../protocol';
import { rackedBalls } from '../../edit/ball_names';
import { selection, shot } from '../../state/state';
import { canPot, seekPot } from '../../solve/search';
import { pocketWords } from '../../solve/solution_text';
import { openMenu, type MenuItem } from '../menu/menu_state';
import { contactDistance } from './ball_snap';
import { valueAt } from './shot_values';
import { shownStrike } from './strike';

const kPrecision = 1e-4; // m

function item(label: string, changes: Change[], startsGroup = false): MenuItem {
    return { label, startsGroup, run: () => { applyChanges(changes, label, true); } };
}

/// Adds a strike at the end of the events and selects it.
function addStrike(label: string, yaml: string): void {
    const count = shot.peek()?.events.length ?? 0;
    if (insertItem(['events'], count, `strike: ${yaml}`, label).ok) {
        selection.value = ['events', String(count)];
    }
}

/// The strike is aimed at the ball, or a new one strikes it.
function strikeItems(ball: SceneObject): MenuItem[] {
    const events = shot.peek()?.events ?? [];
    const strike = shownStrike.peek()?.event;
    const isStruck = events.some(({ kind, object }) => kind === 'strike' && object === ball.name);
    const cue = shot.peek()?.names.balls.find((name) => name === 'cue');
    const isFirst = events.every(({ kind }) => kind !== 'strike');
    const aim = isFirst && cue && cue !== ball.name ? [{
        label: `Strike ${cue} at ${ball.name}`, startsGroup: true,
        run: () => addStrike(`Strike ${cue} at ${ball.name}`,
            `{ball: ${cue}, at: 0.5 s, toward: ${ball.name}, speed: 3 m/s}`),
    }] : strike && strike.object !== ball.name ? [
        item(`Strike ${strike.object} at ${ball.name}`, [{
            path: [...strike.path, 'strike', 'toward'], value: ball.name,
        }], true),
    ] : [];
    const label = `Strike ${ball.name}`;
    return isStruck ? aim : [...aim, {
        label, startsGroup: aim.length === 0,
        run: () => addStrike(label,
            `{ball: ${ball.name}, at: 0.5 s, direction: 0 deg, speed: 2 m/s}`),
    }];
}

function placeItems(ball: SceneObject): MenuItem[] {
    const [x, y] = ball.position;
    if (valueAt([...ball.path, 'touching']) !== undefined) {
        return [item(`Free ${ball.name} where it lies`, [{
            path: [...ball.path, 'at'], value: [x, y], precision: kPrecision / 100,
        }])];
    }
    const others = (shot.peek()?.objects ?? []).filter((one) => one.kind === 'ball'
        && one.name !== ball.name && valueAt([...one.path, 'touching', 'ball']) !== ball.name);
    const gap = (one: SceneObject) => Math.hypot(one.position[0] - x, one.position[1] - y)
        - contactDistance(one.radius, ball.radius);
    const nearest = others.sort((a, b) => gap(a) - gap(b))[0];
    if (!nearest) {
        return [];
    }
    const angle = Math.atan2(y - nearest.position[1], x - nearest.position[0]);
    const degrees = Number(((angle * 180) / Math.PI).toFixed(1));
    return [item(`Place ${ball.name} against ${nearest.name}`, [{
        path: [...ball.path, 'touching'],
        value: { yaml: `{ball: ${nearest.name}, direction: ${degrees} deg}` },
    }])];
}

function rackItems(ball: SceneObject): MenuItem[] {
    const isRacked = rackedBalls(valueAt(['rack', 'set'])).includes(ball.name);
    const entry = valueAt(ball.path);
    const key = ['at', 'touching'].find((one) => valueAt([...ball.path, one]) !== undefined);
    if (!isRacked || key === undefined) {
        return [];
    }
    const isAll = typeof entry === 'object' && Object.keys(entry).length === 1;
    return [{
        label: `Return ${ball.name} to the rack`,
        run: () => { removeValue(isAll ? ball.path : [...ball.path, key], `Rack ${ball.name}`, true); },
    }];
}

/// Strikes are sought that pot the ball: in the best pocket, or in one that a second menu offers.
function potItems(ball: SceneObject, x: number, y: number): MenuItem[] {
    const pockets = shot.peek()?.pockets ?? [];
    return !canPot(ball) ? [] : [
        { label: `Pot ${ball.name}`, startsGroup: true, run: () => seekPot(ball.name, '') },
        {
            label: `Pot ${ball.name} in …`,
            run: () => openMenu({
                title: `Pot ${ball.name} in`, x, y,
                items: () => pockets.map(({ name }) => ({
                    label: pocketWords(name), run: () => seekPot(ball.name, name),
                })),
            }),
        },
    ];
}

/// `x`, `y`: where the menu is, CSS pixels of the page.
export function ballItems(ball: SceneObject, x: number, y: number): MenuItem[] {
    return [...potItems(ball, x, y), ...strikeItems(ball), ...placeItems(ball), ...rackItems(ball)];
}
