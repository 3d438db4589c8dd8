// The licences of everything that a bundle contains.
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';

/// Licences under which code and fonts may be bundled. Another one fails the build until a person
/// has read it and added it here.
const kAccepted = new Set(['MIT', 'ISC', 'BSD-2-Clause', 'BSD-3-Clause', 'Apache-2.0', 'OFL-1.1']);

/// The folders of the packages that `inputs` (paths below the studio's folder) came from, sorted.
function packageFolders(inputs) {
    const folders = new Set();
    for (const input of inputs) {
        const found = /^(?:.*\/)?node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
        if (found) {
            folders.add(input.slice(0, found[0].length - 1));
        }
    }
    return [...folders].sort();
}

/// The text of a package's licence file.
async function licenceText(folder, name) {
    const files = (await readdir(folder)).filter((file) => /^licen[cs]e(\.|$)/i.test(file)).sort();
    if (files.length === 0) {
        throw new Error(`the package ${name} has no licence file`);
    }
    return (await readFile(join(folder, files[0]), 'utf8')).trim();
}

/// One text with name, version, licence and the licence's text of every package in `inputs`. Throws
/// if one has a licence that is not in kAccepted, or none.
export async function collectLicences(root, inputs) {
    const parts = ['The page of carom\'s studio contains these packages.'];
    for (const folder of packageFolders(inputs)) {
        const path = join(root, folder);
        const about = JSON.parse(await readFile(join(path, 'package.json'), 'utf8'));
        if (!kAccepted.has(about.license)) {
            throw new Error(`the package ${about.name} has the licence '${about.license}', ` +
                'which is not on the list of accepted ones in licences.mjs');
        }
        const title = `${about.name} ${about.version} (${about.license})`;
        parts.push(`${title}\n${'='.repeat(title.length)}\n\n${await licenceText(path, about.name)}`);
    }
    return parts.join('\n\n\n') + '\n';
}
