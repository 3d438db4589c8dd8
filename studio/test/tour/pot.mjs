// A ball is potted by pointing at it, and the cue ball's end is dragged; then the strike that was written.
import { dragPixels, pixelOf } from '../browser/harness.mjs';
import { keep, scheme, toView } from './steps.mjs';

export const shot = 'solve_red_black.yaml';

export async function tour(page) {
    await scheme(page, 'dark');
    await page.waitForFunction(() => window.studio.view.context.meshNode('red'));
    await toView(page);
    await page.keyboard.press('1');
    const red = await page.evaluate(() => window.studio.state.shot.value.objects
        .find(({ name }) => name === 'red').position);
    await page.mouse.click(...await pixelOf(page, red), { button: 'right' });
    await page.getByRole('menuitem', { name: 'Pot red', exact: true }).click();
    const isFound = () => page.waitForFunction(() => window.studio.solve.found.value.length > 0
        && !window.studio.solve.isSearching.value);
    await isFound();
    const rest = await page.evaluate(() => window.studio.solve.chosen.value.rest);
    await dragPixels(page, await pixelOf(page, [...rest, 0.03]), await pixelOf(page, [1.1, -0.35, 0.03]));
    await isFound();
    await keep(page, 'pot');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.studio.state.strikeMap.value?.rows === 32);
    await keep(page, 'aim');
}
