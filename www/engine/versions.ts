/**
 * The version of what is kept, in the database and in project files. The core reads it, and makes the newest of an older
 * one (`src/document/`).
 */

export const VERSION = 1;
