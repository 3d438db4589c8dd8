// A browser without WebGL shows the plan, which follows the text, and the film's frame with R; the text
// and everything else work as ever.
import { equal, settle } from './harness.mjs';

export const shot = 'bank_shot.yaml';

export const isExtra = true; // only in scripts/test --all, or by name

export async function check({ browser, address }) {
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, deviceScaleFactor: 1 });
    const errors = [];
    page.on('pageerror', (error) => errors.push(error.message));
    await page.addInitScript(() => {
        const { getContext } = HTMLCanvasElement.prototype;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
            return /webgl/.test(kind) ? null : getContext.call(this, kind, ...rest);
        };
    });
    await page.goto(address);
    const plan = page.getByAltText('The plan of the shot');
    await plan.waitFor();
    await page.waitForFunction(() => document.querySelector('.flat-view img').naturalWidth > 0);
    await settle(page);
    const before = await plan.getAttribute('src');
    await page.evaluate(() => {
        const { edit, state } = window.studio;
        const ball = state.shot.value.objects.find(({ kind }) => kind === 'ball');
        edit.applyChanges([{ path: [...ball.path, 'at'], value: [-0.3, 0.1], precision: 1e-3 }],
            'Move');
    });
    await page.waitForFunction((old) => {
        const image = document.querySelector('.flat-view img');
        return image.getAttribute('src') !== old && image.naturalWidth > 0;
    }, before);

    await page.keyboard.press('r');
    await page.waitForFunction(() => window.studio.state.picture.value?.head.complete);
    await settle(page);
    const head = await page.evaluate(() => window.studio.state.picture.value.head);
    equal(head.stored, true, 'whether it is the film\'s frame');
    const shown = await page.evaluate(() => {
        const canvas = document.querySelector('.flat-view canvas');
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const { pixels } = window.studio.state.picture.value;
        return [canvas.width, canvas.height, canvas.clientHeight > 100,
            data.every((value, i) => i % 4 === 3 || value === pixels[i])];
    });
    equal(shown, [head.width, head.height, true, true], 'the picture on the canvas');
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/no_webgl_view.png` });
    }
    const [download] = await Promise.all([page.waitForEvent('download'),
        page.getByRole('button', { name: 'Save', exact: true }).last().click()]);
    equal(download.suggestedFilename(), 'bank_shot_0.png', 'the name of the saved picture');
    equal(errors, [], 'what is thrown');
    await page.close();
    return 'the plan follows the text, R shows the frame, and it is saved as a picture';
}
