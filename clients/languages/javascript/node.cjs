// For `require`.
const { directional, point, spot } = require("./core.cjs");

module.exports = { directional, point, spot, load: async (source) => (await import("./node.js")).load(source) };
