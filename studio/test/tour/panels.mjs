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
    const dialogs = [
        ['open', () => page.keyboard.press('Control+o')],
        ['save_as', () => page.keyboard.press('Control+Shift+s')],
        ['add_parts', () => command(page, 'Add from file')],
    ];
    for (const [name, act] of dialogs) {
        await toView(page);
        await act();
        await page.getByRole('dialog').first().waitFor();
        await keep(page, name);
        await page.keyboard.press('Escape');
    }
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Find a command' }).fill('cam');
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
