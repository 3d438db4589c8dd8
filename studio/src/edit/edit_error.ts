/// Why an edit is not possible: a sentence for the user.
export class EditError extends Error {}
