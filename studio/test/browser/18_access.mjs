// Without the key nothing is served; the key leaves the address bar.
import { equal } from './harness.mjs';

export async function check({ page, address }) {
    const base = new URL('/', address).href;
    equal(page.url(), base, 'the address that the browser shows');
    equal((await fetch(base)).status, 401, 'the page without the key');
    equal((await fetch(`${base}?key=00000000000000000000000000000000`)).status, 401, 'a wrong key');
    equal((await fetch(address)).status, 200, 'the key');
    const cookie = await page.evaluate(() => document.cookie);
    equal(cookie, '', 'what scripts see of the cookie');
    return 'no key 401, wrong key 401, the key is not shown';
}
