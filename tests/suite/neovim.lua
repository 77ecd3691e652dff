-- Drives Neovim as a client of `partc lsp`; says what it saw line by line, and what went wrong last.
local partc, program = vim.env.PARTC, vim.env.PROGRAM
local function say(text) io.stdout:write(text:gsub("\n", " "), "\n") end
local function until_true(what, condition)
  if not vim.wait(20000, condition, 20) then
    say("waited for " .. what .. " in vain")
    vim.cmd("cquit 1")
  end
end

local ok, trouble = pcall(function()
  vim.cmd("edit " .. vim.fn.fnameescape(program))
  local buffer = vim.api.nvim_get_current_buf()
  vim.bo[buffer].filetype = "klartext"
  -- `vim.lsp.start` came with 0.8.
  local id = vim.lsp.start_client({ name = "partc", cmd = { partc, "lsp" }, root_dir = vim.fn.getcwd() })
  vim.lsp.buf_attach_client(buffer, id)
  local function findings() return vim.diagnostic.get(buffer) end
  until_true("a finding", function() return #findings() > 0 end)
  local found = findings()[1]
  say(("finding %s line %d %s"):format(found.code, found.lnum + 1, found.source))

  local function ask(method, params)
    params.textDocument = vim.lsp.util.make_text_document_params(buffer)
    for _, answer in pairs(vim.lsp.buf_request_sync(buffer, method, params, 20000) or {}) do
      return answer.result
    end
  end
  local hover = ask("textDocument/hover", { position = { line = 1, character = 2 } })
  say("hover " .. (hover and hover.contents.value or "nothing"))
  local range = { start = { line = 0, character = 0 }, ["end"] = { line = 99, character = 0 } }
  for _, hint in ipairs(ask("textDocument/inlayHint", { range = range }) or {}) do
    say(("hint line %d %s"):format(hint.position.line + 1, hint.label))
  end

  -- The wrong word is mended: the finding goes.
  vim.api.nvim_buf_set_lines(buffer, 2, 3, false, { "2 L X+50 F200" })
  until_true("no finding", function() return #findings() == 0 end)
  say("mended")
  vim.lsp.stop_client(id)
end)
if not ok then
  say(tostring(trouble))
  vim.cmd("cquit 1")
end
vim.cmd("qall!")
