/// The commands of the page as a whole.
import { useEffect } from 'preact/hooks';
import { onCommand } from '../state/keys';
import { openDocuments } from '../documents/documents_state';
import { notice, panel, selection } from '../state/state';
import { setUnfolding } from '../text/show';
import { showPath } from '../text/show_path';
import { outlineArea, textArea, toggle } from './layout';
import { switchTheme } from './theme';

/// What gets the focus in each area, in the order of F6.
const kAreas = ['.outline [role=treeitem][tabindex="0"]', '.inspector input, .inspector button',
    '[data-scene-item][tabindex="0"]', 'canvas[data-play-head]', '.cm-content'];

/// Puts the focus into the next area (1) or the one before (-1) that is shown.
function goToArea(direction: 1 | -1): void {
    const found = kAreas.map((one) => document.querySelector<HTMLElement>(one));
    const here = found.findIndex((one) => {
        const area = one?.closest('.outline, .inspector, .view, .scene-list, .strip, .side');
        return area?.contains(document.activeElement) ?? false;
    });
    for (let i = 1; i <= kAreas.length; i += 1) {
        const next = found[(here + direction * i + 2 * kAreas.length) % kAreas.length];
        if (next && next.offsetParent !== null) {
            next.focus();
            return;
        }
    }
}

/// The keys that follow go to the text.
function showSelectionInText(): void {
    const path = selection.peek();
    if (!path || !showPath(path)) {
        notice.value = path ? notice.peek()
            : { kind: 'info', text: 'Nothing is selected that the text could show.' };
    }
}

export function useShellCommands(): void {
    useEffect(() => {
        setUnfolding(() => textArea.size.peek() === 0 && toggle(textArea));
        const endings = [
            onCommand('palette', () => { panel.value = panel.value === 'palette' ? null : 'palette'; }),
            onCommand('film', () => { panel.value = panel.value === 'film' ? null : 'film'; }),
            onCommand('showPlan', () => openDocuments('plan')),
            onCommand('showReport', () => openDocuments('report')),
            onCommand('showPlot', () => openDocuments('plot')),
            onCommand('showContactSheet', () => openDocuments('contact_sheet')),
            onCommand('export', () => openDocuments('export')),
            onCommand('toggleOutline', () => toggle(outlineArea)),
            onCommand('toggleText', () => toggle(textArea)),
            onCommand('showInText', showSelectionInText),
            onCommand('switchTheme', switchTheme),
            onCommand('nextArea', () => goToArea(1)),
            onCommand('previousArea', () => goToArea(-1)),
        ];
        return () => endings.forEach((end) => end());
    }, []);
}
