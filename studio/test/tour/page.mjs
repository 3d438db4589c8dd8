// The page with a break: views, cameras, the traced picture, a film, documents and keys.
import { command, film, keep, scheme, select, toView, traced } from './steps.mjs';

export const shot = 'nine_ball_break.yaml';

export async function tour(page) {
    await scheme(page, 'light');
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await keep(page, 'break');
    await select(page, ['cameras', '0']);
    await scheme(page, 'dark');
    await keep(page, 'camera');
    await toView(page);
    await select(page, null);
    await page.evaluate(() => { location.hash = '#t=3.5'; });
    await page.waitForFunction(() => window.studio.state.filmTime.value === 3.5);
    await page.keyboard.press('c');
    await page.keyboard.press('r');
    await traced(page);
    await keep(page, 'picture');
    await page.keyboard.press('r');
    await film(page, 'draft');
    await page.waitForFunction(() => window.studio.films.thumbnails.value.size > 90, null,
        { timeout: 300000 });
    await keep(page, 'film');
    await page.getByRole('button', { name: 'Stop' }).click();
    await page.waitForFunction(() => window.studio.films.film.value?.state === 'stopped');
    await page.keyboard.press('Escape');
    await scheme(page, 'light');
    await page.getByRole('button', { name: 'Plan, report and contact sheet' }).click();
    await page.waitForFunction(() => document.querySelector('img.plan')?.naturalWidth > 0);
    await keep(page, 'plan');
    await page.getByRole('tab', { name: 'Export' }).click();
    await keep(page, 'export');
    await page.keyboard.press('Escape');
    await command(page, 'Show the keys');
    await page.getByRole('dialog').first().waitFor();
    await keep(page, 'keys');
}
