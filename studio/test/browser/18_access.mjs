// Without the key nothing is served but the page's own files, the key leaves the address bar, and no
// server on another port gets it. A shot of somebody else reads no file outside its folder, and its
// names and texts are text in the page.
import { createServer } from 'node:http';
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

/// What a server on another port of the same machine gets to know from the browser that has the key.
async function checkOtherPort(page, keys) {
    const heard = [];
    const other = createServer((request, response) => {
        heard.push([request.url, ...request.rawHeaders]);
        response.setHeader('Content-Type', 'text/html');
        response.end('<img src=/image><script>window.kept = JSON.stringify({...localStorage}) + document.cookie</script>');
    });
    await new Promise((done) => { other.listen(0, '127.0.0.1', done); });
    const visitor = await page.context().newPage();
    await visitor.goto(`http://127.0.0.1:${other.address().port}/`);
    await visitor.reload();
    const all = JSON.stringify(heard) + await visitor.evaluate(() => window.kept);
    await visitor.close();
    other.close();
    equal(heard.length >= 4, true, 'requests that the other server heard');
    equal(keys.filter((key) => all.includes(key)), [], 'keys that another port gets');
    equal(/cookie/i.test(JSON.stringify(heard)), false, 'cookies');
}

/// The page can be loaded again, and opened a second time by its address.
async function checkSecondWindow(page) {
    await page.reload();
    await page.waitForFunction(() => window.studio?.state.problems.value?.complete);
    const second = await page.context().newPage();
    await second.goto(`${page.url()}#t=1.5`);
    await second.waitForFunction(() => window.studio?.state.problems.value?.complete);
    await second.waitForFunction(() => window.studio.state.filmTime.value === 1.5);
    await second.close();
}

export async function check(context) {
    const { page, address, browser } = context;
    const base = new URL('/', address).href;
    equal(page.url().replace(/#t=.*/, ''), `${base}studio/`, 'the address that the browser shows');
    const keys = [new URL(address).searchParams.get('key'),
        await page.evaluate(() => localStorage.getItem('carom.read_key'))];
    equal((await fetch(base)).status, 401, 'the server without the key');
    equal((await fetch(`${base}?key=00000000000000000000000000000000`)).status, 401, 'a wrong key');
    equal((await fetch(address)).status, 200, 'the key');
    equal((await fetch(`${base}studio/main.js`)).status, 200, 'a file of the page');
    const hash = await page.evaluate(() => window.studio.state.meshes.value);
    for (const path of ['schema.json', 'configs.json', `scene/${hash}.glb`]) {
        equal((await fetch(base + path)).status, 401, path);
        equal((await fetch(`${base}studio/${path}`)).status, 404, `${path} of the page`);
        equal((await fetch(`${base}${keys[0]}/${path}`)).status, 401, `${path} with the other key`);
        equal((await fetch(`${base}${keys[1]}/${path}`)).status, 200, `${path} with its key`);
    }
    await checkOtherPort(page, keys);
    await checkSecondWindow(page);

    const stranger = await browser.newPage();
    await stranger.goto(`${base}studio/`);
    await stranger.getByText('does not know this page').waitFor();
    equal(await stranger.evaluate(() => window.studio.state.files.value), [], 'what a stranger sees');
    await stranger.close();
    await checkMarkup(context);
    await checkForeignFiles(context);
    return 'no key 401, wrong key 401, the key is not shown, and no other port gets it; '
        + '/etc/passwd is refused, markup is text';
}
