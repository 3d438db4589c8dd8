/// The name of the new shot, and the button that writes it.
import { useRef, useState } from 'preact/hooks';
import type { StartFile } from '../protocol';
import { start, welcome } from '../state/state';
import { beginShot } from './file_actions';
import { fileOfName, freeName, problemOfName, titleOf } from './shot_name';

/// The names of the files beside which the new one is written, as far as they are known.
function knownNames(root: string): string[] {
    return (start.value?.recent ?? [])
        .filter(({ file }) => file.startsWith(`${root}/`))
        .map(({ file }) => file.slice(root.length + 1));
}

export function suggestedName(from: StartFile): string {
    return freeName(from.name === 'empty' ? 'new_shot' : `my_${from.name}`,
        knownNames(welcome.value?.root ?? ''));
}

export function NewShot({ from }: { from: StartFile }) {
    const root = welcome.value?.root ?? '';
    const [typed, setTyped] = useState<string | null>(null);  // null: the user has typed nothing
    const name = typed ?? suggestedName(from);
    const field = useRef<HTMLInputElement>(null);
    const problem = problemOfName(name);
    const write = () => {
        if (problem === '') {
            void beginShot(fileOfName(name), from.file);
        } else {
            field.current?.focus();
        }
    };
    return (
        <form class="new_shot" onSubmit={(event) => { event.preventDefault(); write(); }}>
            <span class="from">New shot from <strong>{titleOf(from.name)}</strong></span>
            <label>
                <span class="label">Name</span>
                <input ref={field} type="text" name="name" value={name} spellcheck={false}
                    autocomplete="off" aria-invalid={problem !== ''} aria-describedby="new_shot_where"
                    onFocus={(event) => event.currentTarget.select()}
                    onInput={(event) => setTyped(event.currentTarget.value)} />
            </label>
            <span class={`where ${problem === '' ? '' : 'error'}`} id="new_shot_where" role="status">
                {problem || `${root}/${fileOfName(name)}`}
            </span>
            <button type="submit" class="create" disabled={problem !== ''}>Create</button>
        </form>
    );
}
