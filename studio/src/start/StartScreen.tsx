/// The start page: templates, examples and recent shots.
import { FileInput, FolderOpen, Moon, Sun } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { connectionTrouble } from '../shell/Status';
import { shownTheme, switchTheme } from '../shell/theme';
import type { StartFile } from '../protocol';
import { notice, start, welcome } from '../state/state';
import { Cards } from './Cards';
import { beginShot } from './file_actions';
import { chooseScene } from './import_scene';
import { NewShot, suggestedName } from './NewShot';
import { chooseShot } from './OpenShot';
import { RecentShots } from './RecentShots';
import './start.css';

function Top() {
    const isDark = shownTheme.value === 'dark';
    const Icon = isDark ? Sun : Moon;
    return (
        <header>
            <svg class="mark" viewBox="0 0 32 32" aria-hidden="true">
                <circle cx="16" cy="16" r="15" class="ball" />
                <path d="M1.5 12.2 A15 15 0 0 1 30.5 12.2 L30.5 19.8 A15 15 0 0 1 1.5 19.8 Z"
                    class="stripe" />
                <circle cx="16" cy="16" r="5.4" class="spot" />
            </svg>
            <h1>carom studio</h1>
            <span class="version">{welcome.value?.version}</span>
            <span class="spring" />
            <button type="button" class="tool" aria-label="Dark or light" title="Dark or light"
                onClick={switchTheme}>
                <Icon size={17} strokeWidth={1.75} aria-hidden="true" />
            </button>
        </header>
    );
}

/// The whole page while no shot is open.
export function StartScreen() {
    const offered = start.value;
    const [picked, setPicked] = useState<StartFile | null>(null);
    const chosen = picked ?? offered?.templates[0] ?? null;
    const begin = (from: StartFile) => { void beginShot(suggestedName(from), from.file); };
    const cards = (label: string, files: readonly StartFile[]) => (
        <section>
            <h2>{label}</h2>
            <Cards label={label} files={files} chosen={chosen} onChoose={setPicked}
                onBegin={begin} />
        </section>
    );
    return (
        <div class="start">
            <Top />
            <div class="columns">
                <aside>
                    <div class="ways">
                        <button type="button" onClick={() => { void chooseShot(); }}>
                            <FolderOpen size={16} strokeWidth={1.75} aria-hidden="true" />
                            Open a shot…
                        </button>
                        <button type="button" onClick={chooseScene}>
                            <FileInput size={16} strokeWidth={1.75} aria-hidden="true" />
                            Import a scene…
                        </button>
                    </div>
                    <RecentShots shots={offered?.recent ?? []} />
                </aside>
                <main>
                    {cards('Templates', offered?.templates ?? [])}
                    {cards('Examples', offered?.examples ?? [])}
                </main>
            </div>
            {chosen ? <NewShot from={chosen} /> : null}
            <footer role="status" class={notice.value?.kind === 'error' ? 'error' : ''}>
                {connectionTrouble() || notice.value?.text}
            </footer>
        </div>
    );
}
