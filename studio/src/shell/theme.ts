/// Dark or light, as chosen or as the system is; remembered by the browser.
import { signal } from '@preact/signals';
import { theme, type Theme } from '../state/state';

const kThemes: readonly Theme[] = ['system', 'dark', 'light'];

/// The theme that is shown, for what is drawn on a canvas.
export const shownTheme = signal<'dark' | 'light'>('dark');

/// Applies the theme from now on; to be called once.
export function watchTheme(): void {
    const stored = kThemes.find((one) => one === localStorage.getItem('carom.theme'));
    theme.value = stored ?? 'system';
    const system = matchMedia('(prefers-color-scheme: light)');
    const apply = () => {
        const isLight = theme.value === 'light' || (theme.value === 'system' && system.matches);
        document.documentElement.dataset['theme'] = isLight ? 'light' : 'dark';
        shownTheme.value = isLight ? 'light' : 'dark';
    };
    theme.subscribe((value) => {
        localStorage.setItem('carom.theme', value);
        apply();
    });
    system.addEventListener('change', apply);
}

/// The other of dark and light.
export function switchTheme(): void {
    theme.value = document.documentElement.dataset['theme'] === 'light' ? 'dark' : 'light';
}
