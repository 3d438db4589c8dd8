/// What stands in the place of the view for a film of several shots.
import { FolderOpen } from 'lucide-preact';
import { sequence } from '../state/state';
import { Menu } from '../view/menu/Menu';
import { openPart, shownPart } from './parts';
import './sequence_view.css';

export function SequenceView() {
    const part = sequence.value?.parts[shownPart.value];
    return (
        <div class="sequence-view" role="region" aria-label="The film">
            {part ? (
                <div class="card">
                    <h2>{part.name}</h2>
                    {part.kind === 'shot' ? (
                        <button type="button" onClick={() => openPart(part)}>
                            <FolderOpen size={15} strokeWidth={1.75} aria-hidden="true" />Open shot
                        </button>
                    ) : null}
                </div>
            ) : null}
            <Menu />
        </div>
    );
}
