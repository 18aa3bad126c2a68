/* The search takes a leading hyphen for "without": options of commands, such as --json, are looked for by their names. */
const post = Worker.prototype.postMessage;
Worker.prototype.postMessage = function (message, ...rest) {
  if (message && typeof message.data === "string") message.data = message.data.replace(/(^|\s)-{2,}(?=\w)/g, "$1");
  return post.call(this, message, ...rest);
};
