// With output.denoise, the last round of a frame is the denoised one of `carom frame`, byte for byte,
// at each strength.
import { equal, openText } from './harness.mjs';
import { hashOfFrame, hashOfPicture, traced } from './picture_harness.mjs';

export const isExtra = true; // only in scripts/test --all, or by name
export const ownPage = true;

const kFrame = 12;

function shotOf(strength) {
    return `carom: 1
include: [nine_ball_break.yaml]
render: {samples: 8, noise: 0, size: [320, 180]}
output: {denoise: {strength: ${strength}}}
`;
}

export async function check(where) {
    const hashes = [];
    for (const strength of [1, 0.5]) {
        const { page, path, end } = await openText(where, `denoised_${strength}.yaml`, shotOf(strength));
        try {
            await page.evaluate((frame) => window.studio.state.filmTime.value = frame / 24, kFrame);
            await page.locator('canvas[aria-label="The scene"]').focus();
            await page.keyboard.press('c');
            await page.keyboard.press('r');
            const head = await traced(page);
            equal([head.width, head.height, head.stored], [320, 180, true], 'the last round');
            hashes.push(await hashOfPicture(page));
            equal(hashes.at(-1), hashOfFrame(where.carom, path, kFrame, where.folder), 'the pixels of carom frame');
        } finally {
            await end();
        }
    }
    equal(hashes[0] === hashes[1], false, 'whether the strength is seen');
    return `frame ${kFrame} has the bytes of carom frame at two strengths`;
}
