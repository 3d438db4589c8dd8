// Without the key nothing is served, and the key leaves the address bar. A shot of somebody else
// reads no file outside its folder, and its names and texts are text in the page.
import { equal, openText } from './harness.mjs';

const kMarkup = '<img src=x onerror=window.hacked=1>';
const kText = `carom: 1
include: /etc/passwd
table: {kind: cloth}
balls:
  cue: {at: [0, 0]}
  "${kMarkup}": {at: [0.3, 0]}
objects:
  stolen: {mesh: ../../../../../../etc/passwd, at: [0, 0, 1]}
output: {title: "${kMarkup}"}
cameras:
  - {name: "${kMarkup}", video: [0 s, 1 s], position: [0, -3, 2], target: [0, 0, 0], fov: 40 deg}
`;

/// Markup in a name is a problem, whose sentence quotes it; in a title it is allowed.
async function checkMarkup(context) {
    const { page, end } = await openText(context, 'names.yaml', kText.replace(/^ *(include|stolen|objects).*\n/gm, ''));
    const [problem] = await page.evaluate(() => window.studio.state.problems.value.list);
    equal(problem.message.startsWith(`'${kMarkup}' cannot be the name of a ball`), true, problem.message);
    equal(await page.getByText(problem.message).count() > 0, true, 'the sentence in the page');
    const found = await page.evaluate(() => ({
        images: document.querySelectorAll('img[src="x"]').length, hacked: window.hacked ?? 0,
    }));
    equal(found, { images: 0, hacked: 0 }, 'markup in the page');
    await end();
}

async function checkForeignFiles(context) {
    const text = kText.replaceAll(kMarkup, 'other');
    const { page, end } = await openText(context, 'foreign.yaml', text);
    const { list, texts } = await page.evaluate(() => ({
        list: window.studio.state.problems.value.list.map((one) => one.message),
        texts: JSON.stringify(window.studio.state.files.value.map(({ text }) => text)),
    }));
    equal(list.some((one) => one.includes('/etc/passwd')), true, list.join('; '));
    equal(texts.includes('root:'), false, 'what was read');
    await end();
}

export async function check(context) {
    const { page, address } = context;
    const base = new URL('/', address).href;
    equal(page.url(), base, 'the address that the browser shows');
    equal((await fetch(base)).status, 401, 'the page without the key');
    equal((await fetch(`${base}?key=00000000000000000000000000000000`)).status, 401, 'a wrong key');
    equal((await fetch(address)).status, 200, 'the key');
    const cookie = await page.evaluate(() => document.cookie);
    equal(cookie, '', 'what scripts see of the cookie');
    await checkMarkup(context);
    await checkForeignFiles(context);
    return 'no key 401, wrong key 401, the key is not shown; /etc/passwd is refused, markup is text';
}
