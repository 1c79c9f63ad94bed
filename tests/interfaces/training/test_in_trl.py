"""TRL's own loop plays on painted tables: GRPOTrainer, with replies that are written here.

Only the sampling of replies is replaced: the trainer makes the environments, renders their tools,
reads calls out of tokens, carries them out, asks for rewards and takes a step.
"""

from __future__ import annotations

import json
from functools import partial

import pytest

from interfaces.training.painted_tables import painted_tables
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.interfaces.training.environment import ProbeEnv
from probe.train.tune import libraries
from small_models import small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]


def called(name: str, **arguments: object) -> str:
    return f"<tool_call>\n{json.dumps({'name': name, 'arguments': arguments})}\n</tool_call>"


def replies(letter: str) -> list[str]:
    return [
        called("perceive_scene"),
        called("find_object", description="white ball"),
        called("answer_question", choice=letter),
        called("push", object_id="object_1", direction="up", distance_cm=5),
        "I have answered.",
    ]


@pytest.fixture(scope="module")
def trained(tmp_path_factory):
    """The trainer after a step of two tasks, each played rightly and wrongly, and the records."""
    transformers, trl = libraries.transformers(), libraries.trl()
    folder = tmp_path_factory.mktemp("grpo")
    model = small_model(folder, small_dataset(folder, pictures=False), pictures=False)

    class Scripted(trl.GRPOTrainer):
        turn = 0
        told: tuple[str, ...] = ()

        def _generate_single_turn(self, prompt_ids, *_, **__):
            self.told = tuple(self._tokenizer.decode(ids) for ids in prompt_ids)
            said = list[list[int]]()
            for number, env in enumerate(self.environments):
                right = env._seat.job.task.answer
                wrong = next(it for it in "ABCD" if it != right)
                reply = replies(wrong if number % 2 else right)[self.turn]
                said.append(self._tokenizer.encode(reply + "<|im_end|>", add_special_tokens=False))
            self.turn += 1
            return said, None

    settings = trl.GRPOConfig(
        str(folder / "out"),
        use_cpu=True,
        bf16=False,
        report_to="none",
        per_device_train_batch_size=4,
        num_generations=2,
        max_steps=1,
        max_completion_length=8000,
        logging_steps=1,
        save_strategy="no",
    )
    with painted_tables(folder, most=4, out=folder / "records") as tables:
        trainer = Scripted(
            transformers.AutoModelForCausalLM.from_pretrained(model),
            args=settings,
            train_dataset=libraries.part("datasets").Dataset.from_list(tables.rows()[:2]),
            processing_class=transformers.AutoTokenizer.from_pretrained(model),
            environment_factory=partial(ProbeEnv, tables),
        )
        trainer.train()
        rewards = [env.get_reward() for env in trainer.environments]
    return trainer, rewards, folder / "records"


def test_every_rollout_has_its_reward_and_calls_after_the_answer_do_nothing(trained):
    trainer, rewards, records = trained
    assert rewards == [1.0, 0.0, 1.0, 0.0]
    log = trainer.state.log_history[0]
    assert log["reward"] == 0.5 and log["rewards/ProbeEnv/mean"] == 0.5
    assert log["tools/failure_frequency"] == 0
    assert all("The episode has ended; no further call" in text for text in trainer.told)
    names = ["perceive_scene", "find_object", "answer_question"]
    for record in read_records(records / RECORDS):
        assert [step.call.name for step in record.steps] == names
