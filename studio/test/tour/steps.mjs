// What the parts of the tour have in common: waiting, choosing, and keeping pictures.
import { join, resolve } from 'node:path';
import { settle } from '../browser/harness.mjs';

export const kRadius = 0.028575; // m, of a pool ball

/// The folder of the pictures.
export function pictures() {
    return resolve(process.argv[3]);
}

/// Hides where the shots of the tour are.
async function hidePlaces(page) {
    await page.evaluate(() => {
        for (const node of document.querySelectorAll('.where, .head p, footer, .written, .cm-line span, .ways_to button')) {
            for (const text of node.childNodes) {
                if (text.nodeType === Node.TEXT_NODE) {
                    text.data = text.data.replace(/\/\S*carom-studio-\w+/, '~/shots')
                        .replace(/=\/\S*\/configs\//, '=configs/').replace(/^carom-studio-\w+$/, 'shots');
                }
            }
        }
    });
}

/// Keeps a picture of the page once everything is answered and drawn.
export async function keep(page, name) {
    if (await page.evaluate(() => !window.studio.state.isStarting.value)) {
        await settle(page);
        await page.waitForFunction(() => {
            const { state, sound } = window.studio;
            const told = state.soundState.value;
            return state.hasErrors.value || state.isDeferred.value || (told
                && told.v >= state.textVersion.value && (told.reason
                || (told.ready === told.samples && sound.data.value?.address === told.address)));
        });
    }
    // A frame is drawn after the answers have come.
    await page.evaluate(() => new Promise((done) =>
        requestAnimationFrame(() => requestAnimationFrame(done))));
    await hidePlaces(page);
    await page.screenshot({ path: join(pictures(), `${name}.png`) });
    console.log(name);
}

/// Gives the view the keys.
export function toView(page) {
    return page.locator('canvas[aria-label="The scene"]').focus();
}

export async function scheme(page, colorScheme) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate((name) => { window.studio.state.theme.value = name; }, colorScheme);
}

export async function traced(page) {
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete
        && !window.studio.state.pictureAsked.value, null, { timeout: 300000 });
}

/// Finds a command by its words and runs it.
export async function command(page, words) {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Find a command' }).fill(words);
    await page.keyboard.press('Enter');
}

export function select(page, path) {
    return page.evaluate((keys) => { window.studio.state.selection.value = keys; }, path);
}

export function placeOf(page, name) {
    return page.evaluate((one) => window.studio.state.shot.value.objects
        .find((object) => object.name === one).position, name);
}

export async function film(page, quality) {
    await page.keyboard.press('Control+Enter');
    await page.getByLabel('Quality').selectOption(quality);
    await page.getByRole('button', { name: /ender$/ }).click();
}

export async function filmDone(page, frame) {
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'done', null,
        { timeout: 900000 });
    await page.waitForFunction(() => document.querySelector('video')?.readyState >= 2);
    await page.getByRole('slider', { name: 'Frame' }).fill(String(frame));
    await page.waitForFunction(() => !document.querySelector('video').seeking);
}
