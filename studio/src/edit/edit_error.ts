/// Why an edit is not possible: a sentence for the user.
export class EditError extends Error {}

/// The text is written in a way that has no place for an addition: the user can make it.
export class PlaceError extends EditError {}
