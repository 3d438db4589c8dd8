/// `window.studio`: how tests see the page.
import { effect } from '@preact/signals';
import * as state from './state';

/// Resolves when no edit is under way, the newest texts are answered, and no picture is asked for.
export function idle(): Promise<void> {
    return new Promise((resolve) => {
        let dispose: (() => void) | null = null;
        let done = false;
        dispose = effect(() => {
            if (state.isIdle.value && !done) {
                done = true;
                queueMicrotask(() => dispose?.());
                resolve();
            }
        });
    });
}

export interface Studio {
    state: typeof state;
    idle(): Promise<void>;
    /// What parts of the page add for their own tests.
    [name: string]: unknown;
}

declare global {
    interface Window {
        studio: Studio;
    }
}

/// Makes `window.studio`.
export function exposeStudio(): void {
    window.studio = { state, idle };
}
