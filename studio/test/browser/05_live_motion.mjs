// While a ball is dragged its motion follows, also while a picture refines and while a film is made:
// answers come during the drag, none is older than the one before, and the last one is of the last
// text. How quickly they come is measured by bench/studio.
import { kPatience, equal, pixelOf, settle } from './harness.mjs';

const kMoves = 24;
const kMostMoves = 2000;  // where other programs keep the processor busy
const kFewest = 5;  // answers during a drag, which goes on until they have come

/// Notes the versions of all motions that come from now on.
function watch(page) {
    return page.evaluate(() => {
        window.versions = [];
        window.endWatch?.();
        window.endWatch = window.studio.state.timeline.subscribe((one) => {
            if (one) {
                window.versions.push(one.head.v);
            }
        });
    });
}

/// Drags the cue ball to and fro along an arc, a move with each frame of the page. Returns how many
/// moves and motions there were before the ball was let go.
async function drag(page, what) {
    await watch(page);
    const [x, y] = await pixelOf(page, await page.evaluate(() => window.studio.state.shot.value.objects
        .find((one) => one.name === 'cue').position));
    await page.mouse.move(x, y);
    await page.mouse.down();
    let during = 0;
    let moves = 0;
    while (moves < kMoves || (during < kFewest && moves < kMostMoves)) {
        moves += 1;
        await page.mouse.move(x - kMoves * Math.sin(moves / kMoves), y + 6 * Math.sin(moves / 6));
        during = await page.evaluate(async () => {
            await new Promise(requestAnimationFrame);
            return window.versions.length - 1;
        });
    }
    await page.mouse.up();
    await settle(page);
    const { versions, newest } = await page.evaluate(() => ({
        versions: window.versions, newest: window.studio.state.textVersion.value,
    }));
    equal([...versions].sort((a, b) => a - b), versions, `versions in order, ${what}`);
    equal(versions.at(-1), newest, `the last version, ${what}`);
    equal(during >= kFewest, true, `${during} motions came during ${moves} moves, ${what}`);
    return `${during} motions came during ${moves} moves`;
}

/// The same beside a film, which is being made from before the drag until after it.
async function dragBesideFilm(page) {
    const openFilms = () => page.getByRole('button', { name: /^Make a film/ }).click();
    await openFilms();
    await page.getByLabel('Quality').selectOption('draft');
    await page.getByRole('button', { name: 'Save and render', exact: true }).click();
    await page.waitForFunction(() => window.studio.films.film.value?.finished >= 1, null, { timeout: kPatience });
    await page.keyboard.press('Escape');
    const dragged = await drag(page, 'beside a film');
    equal(await page.evaluate(() => window.studio.films.film.value.state), 'running', 'the film after the drag');
    await openFilms();
    await page.getByRole('button', { name: 'Stop' }).click();
    await page.waitForFunction(() => window.studio.films.film.value.state === 'stopped', null, { timeout: kPatience });
    return dragged;
}

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await page.locator('canvas[aria-label="The scene"]').focus();
    const plain = await drag(page, 'without a picture');
    await page.keyboard.press('r');
    await page.waitForFunction(() => window.studio.state.picture.value !== null);
    const refining = await drag(page, 'with a picture');
    await page.waitForFunction(() => window.studio.state.picture.value.head.v
        === window.studio.state.textVersion.value);
    await page.keyboard.press('r');
    const filming = await dragBesideFilm(page);
    return `${plain}; while a picture refines, ${refining}; while a film is made, ${filming}`;
}
