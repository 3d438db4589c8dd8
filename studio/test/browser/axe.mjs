// The faults of a page for people who use it in other ways, as axe finds them.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const packages = process.env.CAROM_NODE_MODULES || join(here, '../../node_modules');
const axe = readFileSync(join(packages, 'axe-core/axe.min.js'), 'utf8');

/// The serious and critical faults of the page as it is when what appears has appeared: a dialog that is still half transparent has
/// no contrast.
export async function faults(page) {
    await page.evaluate(axe);
    return page.evaluate(async () => {
        const ending = document.getAnimations().filter((one) => one.effect?.getComputedTiming().endTime !== Infinity);
        await Promise.allSettled(ending.map((one) => one.finished));
        const result = await window.axe.run(document, { resultTypes: ['violations'] });
        return result.violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')
            .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((one) => one.html.slice(0, 120)).join(' ')}`);
    });
}
