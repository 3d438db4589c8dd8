/// Shows the questions of edits that could mean several things, and the text of those that the page
/// cannot write.
import { question } from '../edit/question';
import type { EditQuestion } from '../edit/edit_types';
import { sourceOf } from '../edit/origin';
import { notice } from '../state/state';
import { showRange } from '../text/show';
import type { DialogAction } from './Dialog';
import { openDialog } from './open_dialogs';

function copy(text: string): void {
    void navigator.clipboard.writeText(text).then(() => {
        notice.value = { kind: 'info', text: 'The text is copied.' };
    });
}

/// Shows the value at the path, or the deepest one above it.
function showPlace(asked: EditQuestion): void {
    for (let depth = asked.path.length; depth > 0; --depth) {
        const source = sourceOf(asked.path.slice(0, depth));
        if (source) {
            showRange({ file: source.file, line: source.line, column: 1, length: 0 });
            return;
        }
    }
}

function actionsOf(asked: EditQuestion): DialogAction[] {
    const answers = asked.choices.map((choice, i): DialogAction => ({
        label: choice.label, about: choice.about, kind: i === 0 ? 'primary' : 'plain',
        run: choice.apply,
    }));
    const byHand: DialogAction[] = asked.text === '' ? [] : [
        { label: 'Copy and show the place', kind: 'primary',
            run: () => { copy(asked.text); showPlace(asked); } },
    ];
    const cancel: DialogAction = { label: answers.length > 0 ? 'Cancel' : 'Close',
        run: () => undefined };
    return [...answers, ...byHand, cancel];
}

function Body({ asked }: { asked: EditQuestion }) {
    const sentence = asked.message.charAt(0).toUpperCase() + asked.message.slice(1);
    return (
        <>
            <p>{/[.!?]$/.test(sentence) ? sentence : `${sentence}.`}</p>
            {asked.choices.length > 0 ? (
                <dl class="answers">
                    {asked.choices.map((choice) => [
                        <dt key={choice.label}>{choice.label}</dt>,
                        <dd key={`${choice.label} about`}>{choice.about}</dd>,
                    ])}
                </dl>
            ) : null}
            {asked.text === '' ? null
                : <><p>The text to add:</p><pre>{asked.text}</pre></>}
        </>
    );
}

/// Shows questions from now on; to be called once.
export function watchQuestions(): void {
    question.subscribe((asked) => {
        if (asked) {
            question.value = null;
            openDialog({ title: asked.title, body: () => <Body asked={asked} />,
                actions: () => actionsOf(asked) });
        }
    });
}
