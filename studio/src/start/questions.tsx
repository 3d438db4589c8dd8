/// The sentences of questions about files.
export function existsQuestion(name: string) {
    return () => <p>The file <code>{name}</code> would lose what is in it now.</p>;
}

export function unsavedQuestion() {
    return (
        <p>
            The open shot has changes that are in no file yet. They are lost if you do not save them.
        </p>
    );
}
