// The panels and dialogs that the other parts of the tour do not open.
import { settle } from '../browser/harness.mjs';
import { command, keep, scheme, select, toView } from './steps.mjs';

export const shot = 'nine_ball_break.yaml';

async function documents(page) {
    await page.getByRole('button', { name: 'Plan, report and contact sheet' }).click();
    for (const [tab, name] of [['Report', 'report'], ['Speeds and energy', 'speeds']]) {
        await page.getByRole('tab', { name: tab }).click();
        await page.waitForFunction(() => document.querySelector('[role=tabpanel]')?.textContent.length > 100
            || document.querySelector('[role=tabpanel] img')?.naturalWidth > 0);
        await keep(page, name);
    }
    await page.keyboard.press('Escape');
}

export async function tour(page) {
    await scheme(page, 'dark');
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await select(page, ['events', '0']);
    await keep(page, 'strike');
    await select(page, null);
    await documents(page);
    for (const [words, name] of [['Open another', 'open'], ['Save as', 'save_as'], ['Add from', 'add_parts']]) {
        await command(page, words);
        await page.locator('[role=dialog]').waitFor();
        await keep(page, name);
        await page.keyboard.press('Escape');
    }
    await page.keyboard.press('Control+k');
    await page.keyboard.type('cam');
    await keep(page, 'palette');
    await page.keyboard.press('Escape');
    await page.evaluate(() => {
        const text = window.studio.edit.text();
        const at = text.indexOf('toward');
        window.studio.edit.type(at, at + 6, 'towrad');
    });
    await settle(page);
    await keep(page, 'problems');
    await toView(page);
}
