// The first picture of a question is small and the next ones are larger, until all samples are there;
// a question that another one follows gets no more pictures. Times are measured by bench/studio.
import { equal } from './harness.mjs';

const kSmall = 250 * 140;  // pixels of a first picture at most

const kTries = 6;

/// Puts the play head on a frame of the camera `slow` and returns the heads of its pictures.
function pictures(page, filmTime) {
    return page.evaluate((time) => new Promise((resolve) => {
        const { state } = window.studio;
        const asked = state.picture.value?.head.q ?? 0;
        const heads = [];
        const end = state.picture.subscribe((picture) => {
            if (picture && picture.head.q > asked) {
                heads.push(picture.head);
                if (picture.head.complete) {
                    queueMicrotask(() => { end(); resolve(heads); });
                }
            }
        });
        state.filmTime.value = time;
    }), filmTime);
}

export async function check({ page }) {
    await page.evaluate(() => { window.studio.state.filmTime.value = 3; });
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete);

    // A page that is busy gets the newest round only: one of a few tries shows them all.
    let heads = [];
    for (let i = 0; i < kTries && !(heads[0]?.width * heads[0]?.height <= kSmall); ++i) {
        heads = await pictures(page, 3.5 + i / 24);
    }
    const areas = heads.map(({ width, height }) => width * height);
    equal(areas[0] <= kSmall, true, `the size of the first picture (${areas[0]} pixels)`);
    equal([...areas].sort((a, b) => a - b), areas, 'sizes grow');
    equal([heads.at(-1).width, heads.at(-1).height], [640, 360], 'the last size');
    const full = heads.filter(({ width }) => width === 640).map(({ samples }) => samples);
    const rounds = full.slice(0, -1);  // the last number is the mean: noisy pixels have more samples
    equal([...new Set(rounds)].sort((a, b) => a - b), rounds, 'samples grow');
    equal([full.at(-1), heads.at(-1).stored], [heads.at(-1).of_samples, true], 'the last picture');

    // Ten questions in a row: only the last one is answered to its end.
    const seen = await page.evaluate(() => new Promise((resolve) => {
        const { state } = window.studio;
        const last = 4.5;
        const heads = [];
        const asked = state.picture.value.head.q;
        const end = state.picture.subscribe(({ head }) => {
            if (head.q > asked) {
                heads.push(head);
                if (head.complete && state.filmTime.value === last) {
                    queueMicrotask(() => { end(); resolve({ heads, asked }); });
                }
            }
        });
        for (let i = 9; i >= 0; --i) {
            state.filmTime.value = last - i / 24;
        }
    }));
    const questions = seen.heads.map(({ q }) => q);
    equal([...questions].sort((a, b) => a - b), questions, 'questions in order');
    equal(seen.heads.filter(({ complete }) => complete).map(({ q }) => q), [seen.asked + 10],
        'the questions that were answered to the end');
    return `${heads.length} rounds from ${heads[0].width}x${heads[0].height} to 640x360 with `
        + `${full.at(-1)} samples a pixel; of ten questions the last one is finished`;
}
