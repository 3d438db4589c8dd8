/// The dialog for another name of the open shot.
import { signal } from '@preact/signals';
import { openDialog } from '../dialogs/open_dialogs';
import { welcome } from '../state/state';
import { saveShotAs } from './file_actions';
import { fileOfName, problemOfName } from './shot_name';

const name = signal('');

function Field() {
    const problem = problemOfName(name.value);
    const root = welcome.value?.root ?? '';
    return (
        <>
            <label>
                <p>Name</p>
                <input type="text" value={name.value} data-focus spellcheck={false}
                    autocomplete="off" aria-invalid={problem !== ''} aria-describedby="save_as_where"
                    onFocus={(event) => event.currentTarget.select()}
                    onInput={(event) => { name.value = event.currentTarget.value; }} />
            </label>
            <p class="where" id="save_as_where">
                {problem || `${root}/${fileOfName(name.value)}`}
            </p>
            <p>What the shot includes stays where it is and is still found.</p>
        </>
    );
}

/// Asks for a name, and writes the shot as it stands in the page to that file.
export function saveAs(): void {
    const { shot = '', root = '' } = welcome.value ?? {};
    const own = shot.startsWith(`${root}/`) ? shot.slice(root.length + 1) : shot;
    name.value = `${own.replace(/\.ya?ml$/, '')}_2`;
    openDialog({
        title: 'Save as', body: () => <Field />,
        actions: () => [{
            label: 'Save', kind: 'primary', isDisabled: problemOfName(name.value) !== '',
            run: () => saveShotAs(fileOfName(name.value)),
        }],
    });
}
