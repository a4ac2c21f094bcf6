/** An error whose message is a sentence for the user, in the language of the app. */
export class UserError extends Error {
  override readonly name = 'UserError';
}
