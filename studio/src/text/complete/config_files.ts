/// The files of carom's own that a shot may include.
import { withKey } from '../../connection/key';
import { signal } from '@preact/signals';

export interface ConfigFile {
    /// As an `include` names it: "tables/pool_9ft.yaml".
    name: string;
    /// The first comment of the file.
    about: string;
}

export const configFiles = signal<readonly ConfigFile[]>([]);

/// Asks for the list; to be called once.
export async function loadConfigFiles(): Promise<void> {
    const answer = await fetch(withKey('/configs.json'));
    if (answer.ok) {
        configFiles.value = await answer.json() as ConfigFile[];
    }
}
