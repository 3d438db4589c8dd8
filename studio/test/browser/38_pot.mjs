// A ball is potted by pointing: the menu or a drag onto a pocket finds strikes, shown as paths with
// their chances; keys and wheel go through them, the ring of the cue ball's end is dragged, Enter and a
// click write one.
import { faults } from './axe.mjs';
import {
    dragPixels, equal, openText, pixelOf, settle, textOf, undo,
} from './harness.mjs';

const kShot = `carom: 1  # pot
table: {kind: pool}
simulation: {duration: 12 s}
balls:
  cue: {at: [-0.3, -0.1]}
  one: {at: [0.4, 0.2]}
  two: {at: [0.1, -0.3]}
events:
  - strike: {ball: cue, at: 0.5 s, toward: two, speed: 2 m/s}  # the strike
`;
const kLine = 8; // of the strike
const kStrike = /^ {2}- strike: \{ball: cue, at: 0\.5 s, direction: \d+\.?\d* deg, speed: \d\.?\d* m\/s(, tip: \[-?\d\.?\d*, -?\d\.?\d*\])?\} {2}# the strike$/;
const kSizes = [{ width: 1280, height: 720 }, { width: 960, height: 600 }, { width: 1680, height: 1000 }];

/// What the page shows of the search.
function shown(page) {
    return page.evaluate(() => {
        const { found, chosen, chosenIndex, isSearching, wish, solutions } = window.studio.solve;
        const { figure, solutionPieces } = window.studio.gizmos;
        return {
            routes: found.value.map(({ route }) => route), index: chosenIndex.value,
            chosen: chosen.value, isSearching: isSearching.value, wish: wish.value,
            strong: figure('solutions').lines?.length ?? 0, faint: solutionPieces(),
            label: figure('solutions').labels?.[0]?.text ?? '',
            milliseconds: solutions.value?.head.milliseconds,
            message: solutions.value?.head.message,
        };
    });
}

function waitForAll(page) {
    return page.waitForFunction(() => window.studio.solve.wish.value
        && !window.studio.solve.isSearching.value);
}

async function placeOf(page, name) {
    return page.evaluate((one) => window.studio.state.shot.value.objects
        .find((object) => object.name === one).position, name);
}

async function openMenu(page, name) {
    await page.mouse.click(...await pixelOf(page, await placeOf(page, name)), { button: 'right' });
}

/// The bar lies in the view and beside the button of the picture, at several sizes of the window.
async function checkSizes(page, label) {
    for (const size of kSizes) {
        await page.setViewportSize(size);
        await page.waitForTimeout(300);
        const [bar, view, other] = await page.evaluate(() =>
            ['.solution-bar', '.view', '.picture-bar'].map((one) => {
                const { left, right, top, bottom } = document.querySelector(one).getBoundingClientRect();
                return { left, right, top, bottom };
            }));
        equal([bar.left >= view.left, bar.right <= view.right, bar.bottom <= view.bottom,
            bar.left >= other.right || bar.bottom <= other.top], [true, true, true, true],
        `the bar at ${size.width} x ${size.height}`);
        if (process.env.CAROM_STUDIO_SHOTS) {
            await page.screenshot({
                path: `${process.env.CAROM_STUDIO_SHOTS}/38_${label}_${size.width}.png`,
            });
        }
    }
    await page.setViewportSize(kSizes[0]);
    await page.waitForTimeout(200);
}

/// By the menu: paths, keys, wheel, Escape, Enter, undo.
async function checkMenu(page) {
    await openMenu(page, 'one');
    await page.getByRole('menuitem', { name: 'Pot one', exact: true }).click();
    await waitForAll(page);
    const first = await shown(page);
    equal([first.routes.length > 1, first.index, first.strong > 2, first.faint > 2,
        first.message], [true, 0, true, true, ''], 'what is shown first');
    equal(/^1 of \d+: \d+ %$/.test(first.label), true, first.label);
    const bar = await page.getByRole('group', { name: 'Solutions' }).innerText();
    equal(bar.includes(`1 of ${first.routes.length}`) && /\d+ %/.test(bar) && bar.includes('m/s'),
        true, bar);
    await checkSizes(page, 'found');
    equal(await faults(page), [], 'what axe finds in the bar');
    await page.keyboard.press('ArrowRight');
    const next = await shown(page);
    equal([next.index, next.label.startsWith('2 of ')], [1, true], 'after an arrow key');
    const box = await page.locator('.view canvas').boundingBox();
    await page.mouse.move(box.x + 40, box.y + 150);
    await page.mouse.wheel(0, -100);
    await page.waitForFunction(() => window.studio.solve.chosenIndex.value === 0);
    await page.keyboard.press('Escape');
    equal([(await shown(page)).wish, await textOf(page)], [null, kShot], 'after Escape');

    await openMenu(page, 'one');
    await page.getByRole('menuitem', { name: 'Pot one in …' }).click();
    await page.getByRole('menuitem', { name: 'corner right back' }).click();
    await waitForAll(page);
    const inCorner = await shown(page);
    equal(inCorner.chosen.pocket, 'corner_right_back', 'the pocket');
    await page.keyboard.press('Enter');
    await settle(page);
    const line = (await textOf(page)).split('\n')[kLine];
    equal(kStrike.test(line), true, line);
    await page.waitForFunction(() => window.studio.state.timeline.value.head.events
        .some(({ kind, a, b }) => kind === 'potted' && a === 'one' && b === 'corner_right_back'));
    await undo(page, kShot, 'the strike');
    return `${first.routes.length} ways, ${line.trim()}`;
}

/// By a drag onto a pocket: the ball stays, and its place in the text, too. Then the ring is dragged.
async function checkDrag(page) {
    const before = await placeOf(page, 'one');
    const pocket = await page.evaluate(() => window.studio.state.shot.value.pockets
        .find(({ name }) => name === 'corner_right_front').place);
    await dragPixels(page, await pixelOf(page, before), await pixelOf(page, [...pocket, 0]));
    equal([await textOf(page), await placeOf(page, 'one')], [kShot, before], 'after the drag');
    await waitForAll(page);
    equal((await shown(page)).wish.pocket, 'corner_right_front', 'the pocket of the drag');

    const start = await page.evaluate(() => window.studio.solve.chosen.value.rest);
    const goal = [0.1, 0.15];
    const [from, to] = [await pixelOf(page, [...start, 0.03]), await pixelOf(page, [...goal, 0.03])];
    await page.evaluate(() => {
        window.studio.firsts = [];
        window.studio.answers = []; // [question, milliseconds, its best strike; null: none fits]
        let last = window.studio.solve.solutions.value.head.q; // of the pot anywhere
        window.studio.solve.solutions.subscribe((all) => {
            if (all) {
                const [best] = all.head.solutions;
                window.studio.answers.push([all.head.q, Math.round(all.head.milliseconds),
                    best?.is_solved ? `${best.direction} ${best.speed} ${best.tip}` : null]);
            }
            if (all && all.head.q !== last && all.head.solutions.length > 0) {
                last = all.head.q;
                window.studio.firsts.push(Math.round(all.head.milliseconds));
            }
        });
    });
    await page.mouse.move(...from);
    await page.mouse.down();
    for (let i = 1; i <= 20; ++i) {
        await page.mouse.move(from[0] + ((to[0] - from[0]) * i) / 20,
            from[1] + ((to[1] - from[1]) * i) / 20);
        await page.waitForTimeout(60);
    }
    await page.mouse.up();
    await waitForAll(page);
    const { wish, chosen, milliseconds, message } = await shown(page);
    equal([Math.hypot(wish.rest[0] - goal[0], wish.rest[1] - goal[1]) < 0.02, message],
        [true, ''], `the place ${wish.rest}`);
    equal(Math.hypot(chosen.rest[0] - wish.rest[0], chosen.rest[1] - wish.rest[1]) < 0.1501, true,
        `the cue ball ends at ${chosen.rest}`);
    await checkSizes(page, 'place');
    const { firsts, answers } = await page.evaluate(
        () => ({ firsts: window.studio.firsts, answers: window.studio.answers }),
    );
    const ofLast = answers.filter(([question]) => question === answers.at(-1)[0]);
    const fits = ofLast.find(([, , strike]) => strike !== null)[1];
    const best = ofLast.find(([, , strike]) => strike === ofLast.at(-1)[2])[1];
    // A click on the chosen path writes it.
    const middle = await page.evaluate(() => {
        const { view, gizmos, state } = window.studio;
        const box = view.canvas.getBoundingClientRect();
        const length = ({ from: a, to: b }) => Math.hypot(b[0] - a[0], b[1] - a[1]);
        // Where nothing lies over the view, and no ball.
        const isFree = (at) => {
            const [x, y] = view.context.toScreen(at).map((value, k) => value + [box.left, box.top][k]);
            return document.elementFromPoint(x, y) === view.canvas
                && state.shot.value.objects.every(({ kind, position }) => kind !== 'ball'
                    || Math.hypot(position[0] - at[0], position[1] - at[1]) > 0.1);
        };
        return [...gizmos.figure('solutions').lines].sort((a, b) => length(b) - length(a))
            .map(({ from: a, to: b }) => a.map((value, k) => (value + b[k]) / 2)).find(isFree);
    });
    await page.mouse.click(...await pixelOf(page, middle));
    await settle(page);
    const line = (await textOf(page)).split('\n')[kLine];
    equal(kStrike.test(line), true, line);
    await undo(page, kShot, 'the strike with a place');
    return `first answers while dragging ${firsts.join(', ')} ms; of the last one a strike `
        + `that fits after ${fits}, the best after ${best}, all after ${Math.round(milliseconds)} ms`;
}

/// A place that no strike reaches: what is nearest is shown, and the message says why.
async function checkNothing(page) {
    await openMenu(page, 'one');
    await page.getByRole('menuitem', { name: 'Pot one', exact: true }).click();
    await waitForAll(page);
    await page.evaluate(() => {
        const { wish } = window.studio.solve;
        wish.value = { ...wish.value, pocket: 'side_front', rest: [-1.2, 0.6] };
    });
    await waitForAll(page);
    const { routes, chosen, message } = await shown(page);
    equal(routes.length > 0 && chosen.is_solved ? message === '' : message.length > 20, true,
        `the message ${message} of ${routes}`);
    await page.keyboard.press('Escape');
    equal(await textOf(page), kShot, 'the text in the end');
}

export const ownPage = true; // it opens one itself

export async function check(context) {
    const { page, complaints, end } = await openText(context, 'pot.yaml', kShot, kSizes[0]);
    await page.keyboard.press('1');
    await settle(page);
    const byMenu = await checkMenu(page);
    const byDrag = await checkDrag(page);
    await checkNothing(page);
    equal(complaints, [], 'the console');
    await end();
    return `${byMenu}; ${byDrag}`;
}
