/**
 * Version of the saved format, in the database and in project files. The core reads it and migrates older versions
 * (`crates/model/src/`).
 */

export const VERSION = 1;
