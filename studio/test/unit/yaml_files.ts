/// The YAML files of the repository, for tests over all of them.
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

export interface YamlFile {
    name: string;
    text: string;
}

function below(folder: string): string[] {
    return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
        const path = join(folder, entry.name);
        return entry.isDirectory() ? below(path) : entry.name.endsWith('.yaml') ? [path] : [];
    });
}

/// All YAML files below the repository's folders of that name.
export function yamlFiles(...folders: string[]): YamlFile[] {
    return folders.flatMap((folder) => below(join(__REPOSITORY__, folder))).sort().map((path) => ({
        name: relative(__REPOSITORY__, path),
        text: readFileSync(path, 'utf8'),
    }));
}
