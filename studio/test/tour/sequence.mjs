// A film of several shots: its parts on the strip, one of them selected, and the frame at the play head.
import { keep, scheme, select } from './steps.mjs';

export const shot = 'lesson.yaml';

export async function tour(page) {
    await scheme(page, 'dark');
    await page.evaluate(() => { window.studio.state.filmTime.value = 11; });
    await select(page, ['film', 'shots', '2']);
    await page.waitForFunction(() => window.studio.state.pictureAsked.value
        || document.querySelector('.sequence-view canvas'));
    await keep(page, 'sequence');
}
